#pragma once

#include <memory>
#include <optional>

#include "striate/platform/interface/motor_command.hpp"
#include "striate/platform/interface/senses.hpp"
#include "striate/platform/ros/ros_settings.hpp"

namespace striate::ros {

/// Somebody elsewhere who drives by `cmd_vel`, and turns the head by the two joint commands. What
/// it wants still has to pass the safety limiter.
class CmdVelPilot {
 public:
  /// Joins ROS and listens. @param rest where the head looks until a command comes
  CmdVelPilot(const RosSettings& settings, HeadPose rest);
  ~CmdVelPilot();

  /// The newest command; nothing where none has come within `lease`. After a gap in the midst of
  /// motion, theirs or ours, only to stand, until a command to stand has come.
  [[nodiscard]] std::optional<MotorCommand> wanted() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::ros
