#pragma once

#include "striate/agent/mission.hpp"
#include "striate/platform/ros/cmd_vel_pilot.hpp"
#include "striate/platform/ros/ros_publisher.hpp"

namespace striate::agent {

/// Shows a mission to ROS, and lets ROS drive it.
class TellRos {
 public:
  TellRos(const Mission& mission, ros::Tells tells);
  /// Once a cycle.
  void tell(const Mission& mission);

 private:
  [[nodiscard]] static ros::Health health_of(const Mission& mission);

  ros::RosPublisher publisher_;
  TimePoint disparity_stamp_{Duration::min()};
  TimePoint health_told_{Duration::min()};
};

/// `cmd_vel` as a pilot: drives while it is fresh; older than its lease it has no say.
[[nodiscard]] CognitiveCycle::Pilot cmd_vel_pilot(const ros::RosSettings& settings,
                                                  double resting_tilt_rad);

}  // namespace striate::agent
