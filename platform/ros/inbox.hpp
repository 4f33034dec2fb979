#pragma once

#include <deque>
#include <optional>
#include <string>

#include "striate/platform/ros/messages.hpp"
#include "striate/platform/ros/ros_settings.hpp"
#include "striate/platform/ros/stamp_map.hpp"
#include "striate/platform/ros/stereo_pairing.hpp"

namespace striate::ros {

enum class Eye { left, right };

/// What messages say, as senses: the newest of each, stamped in body time. A message that cannot be
/// used changes nothing, and `trouble` says why. No thread, no clock: a live robot and a bag both
/// fill it.
class Inbox {
 public:
  explicit Inbox(const RosSettings& settings);

  void take(Eye eye, const sensor_msgs::Image& message, TimePoint arrived);
  void take(Eye eye, const sensor_msgs::CompressedImage& message, TimePoint arrived);
  void take(Eye eye, const sensor_msgs::CameraInfo& message);
  void take(const nav_msgs::Odometry& message, TimePoint arrived);
  void take(const sensor_msgs::LaserScan& message, TimePoint arrived);
  void take(const sensor_msgs::PointCloud& message, TimePoint arrived);
  void take(const sensor_msgs::JointState& message, TimePoint arrived);

  /// Everything but `now`.
  [[nodiscard]] const Senses& senses() const { return senses_; }
  /// When each came last; nothing: not yet.
  [[nodiscard]] std::optional<TimePoint> images_came() const { return images_came_; }
  [[nodiscard]] std::optional<TimePoint> odometry_came() const { return odometry_came_; }
  [[nodiscard]] std::optional<TimePoint> laser_came() const { return laser_came_; }
  [[nodiscard]] bool camera_known() const { return camera_.known(); }
  [[nodiscard]] bool camera_swapped() const { return camera_.swapped(); }
  /// Why the newest message that could not be used was refused; "" while all could.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  struct HeadAt {
    TimePoint stamp;
    HeadPose head;
  };
  void take_eye(Eye eye, EyeImage image, TimePoint arrived);
  TimePoint body_time(Stream stream, const ::ros::Time& stamp, TimePoint arrived);
  [[nodiscard]] HeadPose head_at(TimePoint stamp) const;

  RosSettings settings_;
  StampMap stamps_;
  StereoPairing pairing_;
  CameraModel camera_;
  int bits_ = 8;  ///< of a pixel: the most that either eye has used so far
  Senses senses_;
  std::deque<HeadAt> heads_;
  std::optional<Pose2> first_pose_;
  std::optional<TimePoint> images_came_;
  std::optional<TimePoint> odometry_came_;
  std::optional<TimePoint> laser_came_;
  std::string trouble_;
};

}  // namespace striate::ros
