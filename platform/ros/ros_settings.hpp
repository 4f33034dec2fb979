#pragma once

#include <string>

#include "striate/config/settings.hpp"
#include "striate/platform/remote/remote_settings.hpp"

namespace striate::ros {

/// Names and deadlines of the ROS side. A relative topic lies below ROS_NAMESPACE. A image topic
/// that ends in "/compressed" carries sensor_msgs/CompressedImage, any other sensor_msgs/Image.
struct RosSettings : remote::RemoteSettings {
  std::string left_image = "stereo/left/image_rect_color";
  std::string right_image = "stereo/right/image_rect_color";
  std::string left_info = "stereo/left/camera_info";
  std::string right_info = "stereo/right/camera_info";
  std::string disparity = "stereo/disparity";
  std::string odometry = "odom";
  std::string scan = "scan";
  std::string sonar = "sonar";
  std::string joints = "joint_states";
  std::string cmd_vel = "cmd_vel";
  std::string pan_joint = "head_pan";
  std::string tilt_joint = "head_tilt";
  std::string pan_command = "head_pan/command";
  std::string tilt_command = "head_tilt/command";
  std::string odometry_frame = "odom";
  std::string base_frame = "base_link";
  std::string head_frame = "head_link";
  std::string camera_frame = "stereo_left_optical";
};

template <class V>
void visit(V& v, RosSettings& s) {
  v.text("left_image", s.left_image, "topic: rectified images of the left eye");
  v.text("right_image", s.right_image, "topic: of the right eye");
  v.text("left_info", s.left_info, "topic: sensor_msgs/CameraInfo of the left eye");
  v.text("right_info", s.right_info, "topic: of the right eye");
  v.text("disparity", s.disparity, "topic: stereo_msgs/DisparityImage, published");
  v.text("odometry", s.odometry, "topic: nav_msgs/Odometry");
  v.text("scan", s.scan, "topic: sensor_msgs/LaserScan");
  v.text("sonar", s.sonar, "topic: sensor_msgs/PointCloud in the base's frame");
  v.text("joints", s.joints, "topic: sensor_msgs/JointState with the head's two joints");
  v.text("cmd_vel", s.cmd_vel, "topic: geometry_msgs/Twist");
  v.text("pan_joint", s.pan_joint, "name of the head's joint to the left");
  v.text("tilt_joint", s.tilt_joint, "name of the head's joint up");
  v.text("pan_command", s.pan_command, "topic: std_msgs/Float64, radians");
  v.text("tilt_command", s.tilt_command, "topic: std_msgs/Float64, radians");
  v.text("odometry_frame", s.odometry_frame, "tf frame of the odometry");
  v.text("base_frame", s.base_frame, "tf frame of the wheel axle's middle");
  v.text("head_frame", s.head_frame, "tf frame of the head: x ahead, y left");
  v.text("camera_frame", s.camera_frame, "tf frame of the left image: x right, y down");
  visit(v, static_cast<remote::RemoteSettings&>(s));
}

}  // namespace striate::ros
