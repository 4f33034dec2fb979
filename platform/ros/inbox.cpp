#include "striate/platform/ros/inbox.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace striate::ros {
namespace {

std::int64_t nanoseconds(const ::ros::Time& stamp) {
  return static_cast<std::int64_t>(stamp.toNSec());
}

}  // namespace

Inbox::Inbox(const RosSettings& settings) : remote::Inbox(settings), ros_(settings) {}

template <class Image>
void Inbox::take_image(Eye eye, const Image& message, TimePoint arrived) {
  try {
    remote::EyeImage image;
    image.stamp_ns = nanoseconds(message.header.stamp);
    image.image = image_of(message, bits());
    image.bits = bits();
    take_eye(eye, std::move(image), arrived);
  } catch (const std::exception& error) {
    refuse(error.what());
  }
}

void Inbox::take(Eye eye, const sensor_msgs::Image& message, TimePoint arrived) {
  take_image(eye, message, arrived);
}

void Inbox::take(Eye eye, const sensor_msgs::CompressedImage& message, TimePoint arrived) {
  take_image(eye, message, arrived);
}

void Inbox::take(Eye eye, const sensor_msgs::CameraInfo& message) {
  take_camera(eye, eye_info_of(message));
}

void Inbox::take(const nav_msgs::Odometry& message, TimePoint arrived) {
  Odometry odometry;
  if (!read(message, odometry)) return refuse("odometry that is no number");
  take_odometry(odometry, nanoseconds(message.header.stamp), arrived);
}

void Inbox::take(const sensor_msgs::LaserScan& message, TimePoint arrived) {
  RangeScan scan;
  read(message, settings().scan_forward_m, scan);
  take_laser(std::move(scan), nanoseconds(message.header.stamp), arrived);
}

void Inbox::take(const sensor_msgs::PointCloud& message, TimePoint arrived) {
  RangeScan scan;
  read(message, scan);
  take_sonar(std::move(scan), nanoseconds(message.header.stamp), arrived);
}

void Inbox::take(const sensor_msgs::JointState& message, TimePoint arrived) {
  HeadPose head = senses().head;
  const std::size_t told = std::min(message.name.size(), message.position.size());
  for (std::size_t i = 0; i < told; ++i) {
    if (!std::isfinite(message.position[i])) continue;
    if (message.name[i] == ros_.pan_joint) head.pan_rad = message.position[i];
    if (message.name[i] == ros_.tilt_joint) head.tilt_rad = message.position[i];
  }
  take_head(head, nanoseconds(message.header.stamp), arrived);
}

}  // namespace striate::ros
