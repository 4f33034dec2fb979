#include "striate/platform/rosbridge/check_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"

namespace striate::rosbridge {
namespace {

struct NamedTopic {
  const char* key;
  const std::string& name;
};

/// Names as ROS has them; "~" and "{}" are for nodes, and rosbridge is another one.
bool is_topic_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '_' || letter == '/';
  });
}

}  // namespace

BridgeAddress check_settings(const BridgeSettings& settings) {
  const TopicNames& t = settings.topics;
  const std::array<NamedTopic, 7> topics{{{"left_image", t.left_image},
                                          {"right_image", t.right_image},
                                          {"left_info", t.left_info},
                                          {"right_info", t.right_info},
                                          {"odometry", t.odometry},
                                          {"scan", t.scan},
                                          {"cmd_vel", t.cmd_vel}}};
  for (auto one = topics.begin(); one != topics.end(); ++one) {
    if (one->name.empty() && &one->name == &t.scan) continue;
    if (!is_topic_name(one->name)) {
      throw UserError(fmt::format(
          "rosbridge.topics.{} '{}': is no name of a topic\n  hint: as /stereo/left/camera_info",
          one->key, plain_text(one->name)));
    }
    const auto same = std::find_if(topics.begin(), one,
                                   [&](const NamedTopic& two) { return two.name == one->name; });
    if (same != one) {
      throw UserError(fmt::format(
          "rosbridge.topics.{0} and rosbridge.topics.{1} are both '{2}'\n  hint: each has its own",
          same->key, one->key, one->name));
    }
  }
  if (!is_plain_text(settings.frame)) {
    throw UserError(fmt::format("rosbridge.frame '{}': is no name of a frame\n  hint: base_link",
                                plain_text(settings.frame)));
  }
  return read_bridge_address(settings.url);
}

}  // namespace striate::rosbridge
