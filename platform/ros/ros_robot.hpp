#pragma once

#include <memory>
#include <string>

#include "striate/platform/interface/robot.hpp"
#include "striate/platform/ros/ros_settings.hpp"

namespace striate::remote {
class ZeroKeeper;
}

namespace striate::ros {

/// A robot that is only reachable through ROS 1, as a body: images, odometry, laser, sonar and
/// the head's joints come as topics, `cmd_vel` goes out.
///
/// Its own gate is the last: while images or odometry, or a laser that has spoken, are silent or
/// late for longer than `stale`, or the newest command is older than `lease`, or the master has not
/// answered for a second, zero is published. Where the program did not run for a while, as when it
/// was suspended, or nobody decided in the midst of motion, it holds until `reset`. With the end of
/// the object zero is published too. When the program dies or is stopped, a node of its own
/// publishes zero, see cmd_vel_keeper.hpp.
class RosRobot final : public Robot {
 public:
  /// Joins ROS and waits for the first images and odometry.
  /// @throws UserError, std::runtime_error that names the topic on which nothing came.
  explicit RosRobot(const RosSettings& settings, const RobotDescription& description = {},
                    Duration patience = std::chrono::seconds(10));
  ~RosRobot() override;

  [[nodiscard]] const RobotDescription& description() const override;
  [[nodiscard]] const Clock& clock() const override;
  /// @throws std::runtime_error when images, odometry or the master are silent for longer
  /// than `lost`.
  bool sense(Senses& senses) override;
  void send(const MotorCommand& command) override;
  void stop() noexcept override;

  /// Why zero is published in spite of a command; "" where the command drives.
  [[nodiscard]] std::string hold() const;
  [[nodiscard]] bool waits_for_reset() const;
  /// Somebody has looked at the robot.
  void reset();

 private:
  struct Parts;
  std::unique_ptr<remote::ZeroKeeper> keeper_;  // first: it must be made before ROS is joined
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::ros
