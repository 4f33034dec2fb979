#pragma once

#include <cstdint>
#include <string>

#include "striate/config/settings.hpp"
#include "striate/platform/remote/remote_settings.hpp"

namespace striate::rosbridge {

/// Which ROS the robot runs: they name types and times differently.
enum class RosVersion : std::uint8_t { one, two };

/// An image topic that ends in "/compressed" carries sensor_msgs/CompressedImage, any other
/// sensor_msgs/Image.
struct TopicNames {
  std::string left_image = "/stereo/left/image_rect_color/compressed";
  std::string right_image = "/stereo/right/image_rect_color/compressed";
  std::string left_info = "/stereo/left/camera_info";
  std::string right_info = "/stereo/right/camera_info";
  std::string odometry = "/odom";
  std::string scan;
  std::string cmd_vel = "/cmd_vel";
};

template <class V>
void visit(V& v, TopicNames& s) {
  v.text("left_image", s.left_image, "rectified images of the left eye");
  v.text("right_image", s.right_image, "of the right eye");
  v.text("left_info", s.left_info, "sensor_msgs/CameraInfo of the left eye");
  v.text("right_info", s.right_info, "of the right eye");
  v.text("odometry", s.odometry, "nav_msgs/Odometry");
  v.text("scan", s.scan, "sensor_msgs/LaserScan; empty: there is no laser");
  v.text("cmd_vel", s.cmd_vel, "geometry_msgs/Twist, or TwistStamped where 'stamped' says so");
}

/// A robot that is reached through a rosbridge server.
struct BridgeSettings : remote::RemoteSettings {
  std::string url;
  RosVersion ros = RosVersion::two;
  bool stamped = false;
  std::string frame = "base_link";
  TopicNames topics;
  /// MB; a raw pair of 1280 x 960 in base64 has 4.9 MB an eye
  int most_message_mb = 16;
};

template <class V>
void visit(V& v, BridgeSettings& s) {
  v.text("url", s.url, "ws://host:9090, of a rosbridge server; empty: there is none");
  v.choice("ros", s.ros, {"1", "2"}, "which ROS the robot runs");
  v.flag("stamped", s.stamped, "cmd_vel is geometry_msgs/TwistStamped");
  v.text("frame", s.frame, "frame of cmd_vel where it is stamped");
  v.section("topics", s.topics);
  v.integer("most_message", s.most_message_mb, {1, 256}, "MB; a larger message ends the line");
  visit(v, static_cast<remote::RemoteSettings&>(s));
}

}  // namespace striate::rosbridge
