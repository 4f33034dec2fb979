#pragma once

#include <memory>
#include <optional>

#include "platform/interface/motor_command.hpp"
#include "platform/interface/senses.hpp"
#include "platform/ros/ros_settings.hpp"

namespace striate::ros1 {

/// Somebody elsewhere who drives by `cmd_vel`, and turns the head by the two joint commands. What
/// it wants still has to pass the safety limiter.
class CmdVelPilot {
 public:
  /// Joins ROS and listens. @param rest where the head looks until a command comes
  CmdVelPilot(const RosSettings& settings, HeadPose rest);
  ~CmdVelPilot();

  /// The newest command; nothing where none has come within `lease`.
  [[nodiscard]] std::optional<MotorCommand> wanted() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::ros1
