#pragma once

#include "striate/platform/remote/inbox.hpp"
#include "striate/platform/ros/messages.hpp"
#include "striate/platform/ros/ros_settings.hpp"

namespace striate::ros {

using remote::Eye;

/// An inbox for the messages of ROS 1: a live robot and a bag both fill it.
class Inbox : public remote::Inbox {
 public:
  explicit Inbox(const RosSettings& settings);

  void take(Eye eye, const sensor_msgs::Image& message, TimePoint arrived);
  void take(Eye eye, const sensor_msgs::CompressedImage& message, TimePoint arrived);
  void take(Eye eye, const sensor_msgs::CameraInfo& message);
  void take(const nav_msgs::Odometry& message, TimePoint arrived);
  void take(const sensor_msgs::LaserScan& message, TimePoint arrived);
  void take(const sensor_msgs::PointCloud& message, TimePoint arrived);
  void take(const sensor_msgs::JointState& message, TimePoint arrived);

 private:
  template <class Image>
  void take_image(Eye eye, const Image& message, TimePoint arrived);

  RosSettings ros_;
};

}  // namespace striate::ros
