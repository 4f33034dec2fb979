#include "striate/platform/rosbridge/operations.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace striate::rosbridge {
namespace {

using nlohmann::json;

constexpr std::int64_t kNanosecondsInSecond = 1'000'000'000;

struct HeardTopic {
  const std::string& topic;
  const char* package;
  const char* type;
};

std::vector<HeardTopic> heard_topics(const BridgeSettings& settings, bool own_images) {
  const TopicNames& topics = settings.topics;
  std::vector<HeardTopic> heard{{topics.odometry, "nav_msgs", "Odometry"}};
  if (own_images) {
    for (const std::string* image : {&topics.left_image, &topics.right_image}) {
      heard.push_back({*image, "sensor_msgs", is_compressed(*image) ? "CompressedImage" : "Image"});
    }
    for (const std::string* info : {&topics.left_info, &topics.right_info}) {
      heard.push_back({*info, "sensor_msgs", "CameraInfo"});
    }
  }
  if (!topics.scan.empty()) heard.push_back({topics.scan, "sensor_msgs", "LaserScan"});
  return heard;
}

/// Each interaction has a name, so that status messages tell what they are about.
std::string id_of(std::string_view operation, const std::string& topic) {
  return fmt::format("striate:{}:{}", operation, topic);
}

json stamp_of(RosVersion ros, std::int64_t stamp_ns) {
  const bool two = ros == RosVersion::two;
  return {{two ? "sec" : "secs", stamp_ns / kNanosecondsInSecond},
          {two ? "nanosec" : "nsecs", stamp_ns % kNanosecondsInSecond}};
}

}  // namespace

std::string type_name(RosVersion ros, std::string_view package, std::string_view type) {
  return fmt::format("{}/{}{}", package, ros == RosVersion::two ? "msg/" : "", type);
}

bool is_compressed(const std::string& image_topic) {
  return image_topic.ends_with("/compressed");
}

std::vector<std::string> greetings(const BridgeSettings& settings, bool own_images) {
  const std::string& cmd_vel = settings.topics.cmd_vel;
  std::vector<std::string> said;
  said.push_back(json{{"op", "advertise"},
                      {"id", id_of("advertise", cmd_vel)},
                      {"topic", cmd_vel},
                      {"type", type_name(settings.ros, "geometry_msgs",
                                         settings.stamped ? "TwistStamped" : "Twist")}}
                     .dump());
  for (const HeardTopic& heard : heard_topics(settings, own_images)) {
    // Where the line is slow, the newest message is wanted, and none that waited behind it.
    said.push_back(json{
        {"op", "subscribe"},
        {"id", id_of("subscribe", heard.topic)},
        {"topic", heard.topic},
        {"type", type_name(settings.ros, heard.package, heard.type)},
        {"queue_length", 1},
        {"compression",
         "none"}}.dump());
  }
  return said;
}

std::vector<std::string> good_byes(const BridgeSettings& settings, bool own_images) {
  std::vector<std::string> said;
  for (const HeardTopic& heard : heard_topics(settings, own_images)) {
    said.push_back(
        json{{"op", "unsubscribe"}, {"id", id_of("subscribe", heard.topic)}, {"topic", heard.topic}}
            .dump());
  }
  said.push_back(json{{"op", "unadvertise"},
                      {"id", id_of("advertise", settings.topics.cmd_vel)},
                      {"topic", settings.topics.cmd_vel}}
                     .dump());
  return said;
}

std::string publish_twist(const BridgeSettings& settings, const MotorCommand& command,
                          std::optional<std::int64_t> stamp_ns) {
  json twist = {{"linear", {{"x", command.forward_m_s}, {"y", 0.0}, {"z", 0.0}}},
                {"angular", {{"x", 0.0}, {"y", 0.0}, {"z", command.turn_rad_s}}}};
  if (settings.stamped) {
    json header = {{"frame_id", settings.frame}};
    if (stamp_ns) header["stamp"] = stamp_of(settings.ros, *stamp_ns);
    twist = {{"header", std::move(header)}, {"twist", std::move(twist)}};
  }
  return json{{"op", "publish"}, {"topic", settings.topics.cmd_vel}, {"msg", std::move(twist)}}
      .dump();
}

}  // namespace striate::rosbridge
