#pragma once

#include <vector>

#include "striate/platform/interface/motor_command.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate {

/// What is fixed about a body: its shape, its limits, where the camera sits.
/// Defaults: Pioneer 3-DX with the paper's mast and turret.
struct RobotDescription {
  double front_m = 0.21;         ///< from the axle to the front end
  double rear_m = 0.30;          ///< from the axle to the rear end
  double half_width_m = 0.2125;  ///< half of 425 mm; P3-DX (ARIA's p3dx.p)
  double corner_m = 0.12;  ///< length of the slanted sides that cut the outline's four corners
  double max_forward_m_s = 0.75;
  double max_turn_rad_s = 1.2;
  double max_acceleration_m_s2 = 0.5;  ///< also the deceleration that a stop may count on
  double max_turn_acceleration_rad_s2 = 2.0;
  double camera_height_m = 1.20;    ///< above the floor
  double camera_forward_m = 0.0;    ///< of the pan axis, from the axle
  double view_rad = radians(43.0);  ///< the camera's horizontal angle; its image is 4:3
  /// Of the head while nothing else is wanted, up positive. Level, the default camera sees the
  /// floor only from 4.1 m on; so tilted, from 2.1 m.
  double resting_tilt_rad = -0.227;
  double max_pan_rad = 1.5;
  double max_tilt_rad = 0.6;
  /// Where its sonar discs sit and look, from the axle, in arrays of eight. Empty: as on a Pioneer
  /// 3-DX, moved to the rim of the outline.
  std::vector<Pose2> sonar_discs{};
  Duration cycle = std::chrono::milliseconds(100);
};

/// A body. `sense` paces the cycle; `stop` must work from every way out of the program.
class Robot {
 public:
  virtual ~Robot() = default;
  [[nodiscard]] virtual const RobotDescription& description() const = 0;
  [[nodiscard]] virtual const Clock& clock() const = 0;

  /// Waits for the next cycle and fills `senses`. False: the body has ended (recording over, run
  /// judged, link closed for good). Throws std::runtime_error when the body is lost.
  virtual bool sense(Senses& senses) = 0;

  /// Hands a command to the motors; it holds until the next one or the body's own watchdog.
  virtual void send(const MotorCommand& command) = 0;

  /// Wheels to a stand, head stays. Never throws; safe to call twice.
  virtual void stop() noexcept = 0;
};

}  // namespace striate
