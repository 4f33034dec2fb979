#include "striate/platform/ros/bag_topics.hpp"

#include <algorithm>
#include <cctype>

#include "striate/base/lower_case.hpp"
#include "striate/platform/ros/choose_eyes.hpp"

namespace striate::ros {
namespace {

/// Type of a camera's geometry; ROS 1 sensor_msgs
constexpr const char* kInfo = "sensor_msgs/CameraInfo";

/// The camera_info of an eye: beside its image, or above it (".../left/image_raw/compressed"), or
/// any whose name begins as the image's up to where the eyes' names differ; never another eye's.
std::string info_of(const BagTopics& topics, const std::string& image, const std::string& other) {
  const auto differ = std::mismatch(image.begin(), image.end(), other.begin(), other.end()).first;
  const auto word_end = std::find_if_not(
      differ, image.end(), [](unsigned char letter) { return std::isalnum(letter) != 0; });
  if (word_end == differ) return {};
  const std::string eye(image.begin(), word_end);
  std::string first;
  for (const auto& [topic, type] : topics) {
    if (type != kInfo || !begins_with(topic, eye)) continue;
    const std::string folder = topic.substr(0, topic.rfind('/') + 1);
    if (begins_with(image, folder)) return topic;
    if (first.empty()) first = topic;
  }
  return first;
}

void find_eyes(const BagTopics& topics, const std::string& camera, RosSettings& s) {
  const EyeTopics eyes = choose_eyes(topics, s, camera);
  const bool infos_there =
      topics.count(full(s.left_info)) > 0 && topics.count(full(s.right_info)) > 0;
  const bool as_wanted = eyes.left == full(s.left_image) && eyes.right == full(s.right_image);
  s.left_image = eyes.left.empty() ? full(s.left_image) : eyes.left;
  s.right_image = eyes.left.empty() ? full(s.right_image) : eyes.right;
  if (as_wanted && infos_there) {
    s.left_info = full(s.left_info);
    s.right_info = full(s.right_info);
    return;
  }
  const std::string left_info = info_of(topics, s.left_image, s.right_image);
  const std::string right_info = info_of(topics, s.right_image, s.left_image);
  s.left_info = left_info.empty() ? full(s.left_info) : left_info;
  s.right_info = right_info.empty() ? full(s.right_info) : right_info;
}

}  // namespace

RosSettings find_topics(const BagTopics& topics, RosSettings s, const std::string& camera) {
  find_eyes(topics, camera, s);
  s.odometry = find(topics, s.odometry, "nav_msgs/Odometry", "");
  s.scan = find(topics, s.scan, "sensor_msgs/LaserScan", "");
  s.sonar = find(topics, s.sonar, "sensor_msgs/PointCloud", "sonar");
  s.joints = find(topics, s.joints, "sensor_msgs/JointState", "");
  return s;
}

std::string list_of(const BagTopics& topics) {
  std::string text;
  for (const auto& [topic, type] : topics) text += "\n  " + topic + ": " + type;
  return text.empty() ? "\n  none" : text;
}

}  // namespace striate::ros
