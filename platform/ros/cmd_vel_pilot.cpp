#include "striate/platform/ros/cmd_vel_pilot.hpp"

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_msgs/Float64.h>

#include <cmath>
#include <mutex>

#include "striate/base/steady_clock.hpp"
#include "striate/platform/remote/command_lease.hpp"
#include "striate/platform/remote/gap_watch.hpp"
#include "striate/platform/ros/messages.hpp"
#include "striate/platform/ros/node.hpp"

namespace striate::ros {

struct CmdVelPilot::Parts {
  Parts(const RosSettings& settings, HeadPose rest);
  void take_command(const MotorCommand& command, TimePoint arrived);
  ::ros::Subscriber hear_angle(const std::string& topic, double& angle_rad);

  SteadyClock clock;
  mutable std::mutex mutex;  ///< guards the three below
  remote::CommandLease lease;
  remote::GapWatch gaps;
  HeadPose head;
  ::ros::CallbackQueue queue;
  ::ros::NodeHandle node;
  std::vector<::ros::Subscriber> subscribers;
  ::ros::AsyncSpinner spinner;
};

CmdVelPilot::Parts::Parts(const RosSettings& settings, HeadPose rest)
    : lease(from_seconds(settings.lease_s)),
      gaps(from_seconds(settings.command_gap_s), from_seconds(settings.lease_s)),
      head(rest),
      spinner(1, &queue) {
  node.setCallbackQueue(&queue);
  boost::function<void(const geometry_msgs::TwistConstPtr&)> take = [this](const auto& message) {
    const std::lock_guard lock(mutex);
    take_command(command_of(*message), clock.now());
  };
  // One waits at most: an old command has no business behind a newer one.
  subscribers = {node.subscribe<geometry_msgs::Twist>(settings.cmd_vel, 1, take, nullptr,
                                                      ::ros::TransportHints().tcpNoDelay()),
                 hear_angle(settings.pan_command, head.pan_rad),
                 hear_angle(settings.tilt_command, head.tilt_rad)};
  spinner.start();
}

/// A Twist does not say how long it was under way. So where commands failed to come in the midst of
/// motion, what comes next may have waited on the line: none drives before one that stands.
void CmdVelPilot::Parts::take_command(const MotorCommand& command, TimePoint arrived) {
  gaps.commanded(command, arrived);
  if (command.forward_m_s == 0.0 && command.turn_rad_s == 0.0) gaps.reset();
  lease.give(gaps.holds() ? MotorCommand{} : command, arrived);
}

::ros::Subscriber CmdVelPilot::Parts::hear_angle(const std::string& topic, double& angle_rad) {
  boost::function<void(const std_msgs::Float64ConstPtr&)> take = [this,
                                                                  &angle_rad](const auto& message) {
    const std::lock_guard lock(mutex);
    if (std::isfinite(message->data)) angle_rad = message->data;
  };
  return node.subscribe<std_msgs::Float64>(topic, 1, take);
}

CmdVelPilot::CmdVelPilot(const RosSettings& settings, HeadPose rest) {
  join_ros("striate");
  parts_ = std::make_unique<Parts>(settings, rest);
}

CmdVelPilot::~CmdVelPilot() {
  parts_->spinner.stop();
}

std::optional<MotorCommand> CmdVelPilot::wanted() const {
  const std::lock_guard lock(parts_->mutex);
  const TimePoint now = parts_->clock.now();
  parts_->gaps.look(now);
  std::optional<MotorCommand> command = parts_->lease.at(now);
  if (!command) return std::nullopt;
  if (parts_->gaps.holds()) command->forward_m_s = command->turn_rad_s = 0.0;
  command->pan_rad = parts_->head.pan_rad;
  command->tilt_rad = parts_->head.tilt_rad;
  return command;
}

}  // namespace striate::ros
