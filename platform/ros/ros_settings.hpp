#pragma once

#include <string>

#include "striate/base/limits.hpp"
#include "striate/config/settings.hpp"

namespace striate::ros {

/// Names and deadlines of the ROS side. A relative topic lies below ROS_NAMESPACE. A image topic
/// that ends in "/compressed" carries sensor_msgs/CompressedImage, any other sensor_msgs/Image.
struct RosSettings {
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

  double pairing_s = 0.02;  ///< a fifth of the cycle; synchronised eyes differ by much less
  double stale_s = 0.5;     ///< five images missed at 10 Hz
  double lost_s = 5.0;      ///< ten times stale_s: what has not come back by then will not (ours)
  double lease_s =
      to_seconds(kCommandLease);  ///< five cycles at 10 Hz, as the Pioneer's safety gate
  double seen_old_s = to_seconds(kCommandLease);     ///< as the Pioneer's safety gate
  double longest_gap_s = to_seconds(kCommandLease);  ///< as the Pioneer's safety gate
  double command_gap_s = 1.0;                        ///< as the Pioneer's safety gate
  double focal_px = 0.0;                             ///< 0: as CameraInfo says
  double baseline_m = 0.0;                           ///< 0: as CameraInfo says
  double fixed_tilt_rad = 0.0;                       ///< a head that looks straight ahead
  double scan_forward_m = 0.0;                       ///< above the axle, unless told
};

template <class V>
void visit(V& v, RosSettings& s) {
  using config::Unit;
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
  v.number("pairing", s.pairing_s, Unit::duration, {0.0, 0.2},
           "left and right belong together when their stamps differ by no more");
  v.number("stale", s.stale_s, Unit::duration, {0.1, 2.0},
           "the robot stands when images or odometry are silent for so long");
  v.number("lost", s.lost_s, Unit::duration, {0.5, 600.0},
           "the mission ends when they are silent for so long");
  v.number("lease", s.lease_s, Unit::duration, {0.05, 0.5}, "an older command does not drive");
  v.number("seen_old", s.seen_old_s, Unit::duration, {0.1, 0.5},
           "a command does not drive when the image it was decided by is older");
  v.number("longest_gap", s.longest_gap_s, Unit::duration, {0.3, 1.0},
           "after not running for so long, as when suspended, it stands until it is reset");
  v.number("command_gap", s.command_gap_s, Unit::duration, {0.5, 10.0},
           "without a command for so long in the midst of motion it stands until it is reset");
  v.number("focal", s.focal_px, Unit::none, {0.0, 100000.0},
           "px; 0: as CameraInfo says; counts before it");
  v.number("baseline", s.baseline_m, Unit::length, {0.0, 10.0},
           "distance of the eyes; 0: as CameraInfo says; counts before it");
  v.number("fixed_tilt", s.fixed_tilt_rad, Unit::angle, {-1.0, 1.0},
           "of a head without joints, up positive");
  v.number("scan_forward", s.scan_forward_m, Unit::length, {-1.0, 1.0},
           "place of the laser ahead of the axle");
}

}  // namespace striate::ros
