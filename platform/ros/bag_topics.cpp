#include "striate/platform/ros/bag_topics.hpp"

#include <vector>

namespace striate::ros {
namespace {

constexpr const char* kImage = "sensor_msgs/Image";  // type of an image; ROS 1 sensor_msgs
/// Type of a compressed image; ROS 1 sensor_msgs
constexpr const char* kCompressed = "sensor_msgs/CompressedImage";
/// Type of a camera's geometry; ROS 1 sensor_msgs
constexpr const char* kInfo = "sensor_msgs/CameraInfo";

/// Bags hold full names.
std::string full(const std::string& topic) {
  return topic.empty() || topic.front() == '/' ? topic : "/" + topic;
}

int merit(const std::string& topic) {
  if (topic.find("rect_color") != std::string::npos) return 3;
  if (topic.find("rect") != std::string::npos) return 2;
  return topic.find("color") != std::string::npos ? 1 : 0;
}

/// The wanted topic, or the best one of these types whose name has `part` in it.
std::string find(const BagTopics& topics, const std::string& wanted,
                 const std::vector<std::string>& types, const std::string& part) {
  const std::string name = full(wanted);
  std::string best;
  for (const auto& [topic, type] : topics) {
    bool fits = false;
    for (const std::string& one : types) fits = fits || type == one;
    if (!fits) continue;
    if (topic == name) return topic;
    if (topic.find(part) == std::string::npos) continue;
    if (best.empty() || merit(topic) > merit(best)) best = topic;
  }
  return best.empty() ? name : best;
}

}  // namespace

RosSettings find_topics(const BagTopics& topics, RosSettings s) {
  s.left_image = find(topics, s.left_image, {kImage, kCompressed}, "left");
  s.right_image = find(topics, s.right_image, {kImage, kCompressed}, "right");
  s.left_info = find(topics, s.left_info, {kInfo}, "left");
  s.right_info = find(topics, s.right_info, {kInfo}, "right");
  s.odometry = find(topics, s.odometry, {"nav_msgs/Odometry"}, "");
  s.scan = find(topics, s.scan, {"sensor_msgs/LaserScan"}, "");
  s.sonar = find(topics, s.sonar, {"sensor_msgs/PointCloud"}, "sonar");
  s.joints = find(topics, s.joints, {"sensor_msgs/JointState"}, "");
  return s;
}

std::string list_of(const BagTopics& topics) {
  std::string text;
  for (const auto& [topic, type] : topics) text += "\n  " + topic + ": " + type;
  return text.empty() ? "\n  none" : text;
}

}  // namespace striate::ros
