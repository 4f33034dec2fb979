#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

#include "striate/platform/interface/robot.hpp"
#include "striate/platform/ros/ros_settings.hpp"

namespace striate::ros {

/// A disparity map with the camera at its size.
struct Disparity {
  cv::Mat1f disparity_px;  ///< +inf where there is no trusted match
  double focal_px = 0.0;
  double baseline_m = 0.0;
  double most_px = 0.0;  ///< largest disparity that was searched
};

/// What a person who looks after the robot wants to know.
struct Health {
  bool ok = true;
  std::string summary;                                       ///< "traverse_corridor: ..."
  std::vector<std::pair<std::string, std::string>> details;  ///< name, value
};

/// What is told: a robot that ROS has already is not told again.
enum class Tells { body_and_mind, mind };

/// Tells ROS 1 what a body feels and what the mind makes of it: odometry and tf, image pairs with
/// CameraInfo, the head's joints, laser, sonar, disparity, diagnostics. Stamps are ROS time.
class RosPublisher {
 public:
  /// Joins ROS. @throws see join_ros()
  RosPublisher(const RosSettings& settings, const RobotDescription& description, Tells tells);
  ~RosPublisher();

  /// Once a cycle, before the others. Images go out once each.
  void publish(const Senses& senses);
  /// @param stamp of the image that it was made from, in body time
  void publish(const Disparity& disparity, TimePoint stamp);
  /// On `/diagnostics`.
  void publish(const Health& health);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::ros
