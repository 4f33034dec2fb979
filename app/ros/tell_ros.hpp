#pragma once

#include "app/mission.hpp"
#include "platform/ros/cmd_vel_pilot.hpp"
#include "platform/ros/ros_publisher.hpp"

namespace striate {

/// Shows a mission to ROS, and lets ROS drive it.
class TellRos {
 public:
  TellRos(const Mission& mission, ros1::Tells tells);
  /// Once a cycle.
  void tell(const Mission& mission);

 private:
  [[nodiscard]] static ros1::Health health_of(const Mission& mission);

  ros1::RosPublisher publisher_;
  TimePoint disparity_stamp_{Duration::min()};
  TimePoint health_told_{Duration::min()};
};

/// `cmd_vel` as a pilot: drives while it is fresh; older than its lease it has no say.
[[nodiscard]] CognitiveCycle::Pilot cmd_vel_pilot(const ros1::RosSettings& settings);

}  // namespace striate
