#include "striate/platform/ros/inbox.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

namespace striate::ros {
namespace {

/// Poses of the head: 0.6 s at 100 Hz, longer than an image may be late (stale_s)
constexpr std::size_t kHeadsKept = 64;

std::int64_t nanoseconds(const ::ros::Time& stamp) {
  return static_cast<std::int64_t>(stamp.toNSec());
}

}  // namespace

Inbox::Inbox(const RosSettings& settings)
    : settings_(settings),
      pairing_(from_seconds(settings.pairing_s)),
      camera_(settings.focal_px, settings.baseline_m) {
  senses_.head.tilt_rad = settings.fixed_tilt_rad;
}

TimePoint Inbox::body_time(Stream stream, const ::ros::Time& stamp, TimePoint arrived) {
  stamps_.learn(stream, nanoseconds(stamp), arrived);
  return stamps_.to_body(nanoseconds(stamp), arrived);
}

void Inbox::take(Eye eye, const sensor_msgs::Image& message, TimePoint arrived) {
  try {
    take_eye(eye, {nanoseconds(message.header.stamp), image_of(message, bits_), bits_}, arrived);
  } catch (const std::exception& error) {
    trouble_ = error.what();
  }
}

void Inbox::take(Eye eye, const sensor_msgs::CompressedImage& message, TimePoint arrived) {
  try {
    take_eye(eye, {nanoseconds(message.header.stamp), image_of(message, bits_), bits_}, arrived);
  } catch (const std::exception& error) {
    trouble_ = error.what();
  }
}

void Inbox::take_eye(Eye eye, EyeImage image, TimePoint arrived) {
  // Even an unpaired image tells how the clocks lie to each other.
  stamps_.learn(eye == Eye::left ? Stream::left : Stream::right, image.stamp_ns, arrived);
  const auto pair =
      eye == Eye::left ? pairing_.add_left(std::move(image)) : pairing_.add_right(std::move(image));
  if (!pair) return;
  if (pair->left.image.size() != pair->right.image.size()) {
    trouble_ = "left and right images have different sizes";
    return;
  }
  if (!camera_.known()) {
    trouble_ = camera_.swapped() ? "by CameraInfo the left and the right topics are swapped"
                                 : "the camera's focal length and baseline are not known yet";
    return;
  }
  // Once or twice in a session, while it is found out how many bits the camera has.
  if (pair->left.bits != pair->right.bits) return;
  StereoFrame frame;
  frame.stamp = stamps_.to_body(pair->left.stamp_ns, arrived);
  frame.left = pair->left.image;
  frame.right = pair->right.image;
  frame.head = head_at(frame.stamp);
  camera_.fill(frame);
  senses_.stereo = frame;
  images_came_ = arrived;
}

void Inbox::take(Eye eye, const sensor_msgs::CameraInfo& message) {
  eye == Eye::left ? camera_.set_left(eye_info_of(message))
                   : camera_.set_right(eye_info_of(message));
}

void Inbox::take(const nav_msgs::Odometry& message, TimePoint arrived) {
  Odometry odometry;
  if (!read(message, odometry)) {
    trouble_ = "odometry that is no number";
    return;
  }
  if (!first_pose_) first_pose_ = odometry.pose;
  odometry.pose = inverse_transform(*first_pose_, odometry.pose);
  odometry.stamp = body_time(Stream::odometry, message.header.stamp, arrived);
  senses_.odometry = odometry;
  odometry_came_ = arrived;
}

void Inbox::take(const sensor_msgs::LaserScan& message, TimePoint arrived) {
  read(message, settings_.scan_forward_m, senses_.laser);
  senses_.laser.stamp = body_time(Stream::laser, message.header.stamp, arrived);
  laser_came_ = arrived;
}

void Inbox::take(const sensor_msgs::PointCloud& message, TimePoint arrived) {
  read(message, senses_.sonar);
  senses_.sonar.stamp = body_time(Stream::sonar, message.header.stamp, arrived);
}

void Inbox::take(const sensor_msgs::JointState& message, TimePoint arrived) {
  HeadPose head = senses_.head;
  const std::size_t told = std::min(message.name.size(), message.position.size());
  for (std::size_t i = 0; i < told; ++i) {
    if (!std::isfinite(message.position[i])) continue;
    if (message.name[i] == settings_.pan_joint) head.pan_rad = message.position[i];
    if (message.name[i] == settings_.tilt_joint) head.tilt_rad = message.position[i];
  }
  senses_.head = head;
  // Wheels and head may be told by several publishers: this topic tells nothing of clocks.
  heads_.push_back({stamps_.to_body(nanoseconds(message.header.stamp), arrived), head});
  if (heads_.size() > kHeadsKept) heads_.pop_front();
}

HeadPose Inbox::head_at(TimePoint stamp) const {
  HeadPose head = senses_.head;
  Duration nearest = Duration::max();
  for (const HeadAt& one : heads_) {
    const Duration apart = one.stamp > stamp ? one.stamp - stamp : stamp - one.stamp;
    if (apart >= nearest) continue;
    nearest = apart;
    head = one.head;
  }
  return head;
}

}  // namespace striate::ros
