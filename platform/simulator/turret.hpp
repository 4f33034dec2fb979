#pragma once

#include <algorithm>
#include <cmath>

#include "striate/base/pioneer_devices.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::simulator {

/// The pan/tilt head: two servos with a speed and end stops, told by encoder steps.
class Turret {
 public:
  Turret(const RobotDescription& robot, double speed_rad_s)
      : max_pan_rad_(robot.max_pan_rad), max_tilt_rad_(robot.max_tilt_rad), speed_(speed_rad_s) {}

  void step(double dt_s, double wanted_pan_rad, double wanted_tilt_rad) {
    pose_.pan_rad = moved(pose_.pan_rad, wanted_pan_rad, max_pan_rad_, dt_s);
    pose_.tilt_rad = moved(pose_.tilt_rad, wanted_tilt_rad, max_tilt_rad_, dt_s);
  }
  [[nodiscard]] const HeadPose& true_pose() const { return pose_; }

  /// As the servos report it: in steps of a Dynamixel AX-12.
  [[nodiscard]] HeadPose reported() const {
    return {std::round(pose_.pan_rad / kServoStep_rad) * kServoStep_rad,
            std::round(pose_.tilt_rad / kServoStep_rad) * kServoStep_rad};
  }

 private:
  [[nodiscard]] double moved(double now, double wanted, double limit, double dt_s) const {
    if (!std::isfinite(wanted)) return now;
    const double change = std::clamp(wanted, -limit, limit) - now;
    return now + std::clamp(change, -speed_ * dt_s, speed_ * dt_s);
  }
  double max_pan_rad_;
  double max_tilt_rad_;
  double speed_;
  HeadPose pose_;
};

}  // namespace striate::simulator
