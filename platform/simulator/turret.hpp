#pragma once

#include <algorithm>
#include <cmath>

#include "platform/interface/robot.hpp"

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

  /// As the servos report it: in steps of 300 deg / 1023 (Dynamixel AX-12).
  [[nodiscard]] HeadPose reported() const {
    /// AX-12A control table: 0 .. 1023 is 0 .. 300 deg
    constexpr double kStepRad = radians(300.0) / 1023.0;
    return {std::round(pose_.pan_rad / kStepRad) * kStepRad,
            std::round(pose_.tilt_rad / kStepRad) * kStepRad};
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
