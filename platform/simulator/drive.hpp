#pragma once

#include <deque>

#include "striate/platform/interface/robot.hpp"
#include "striate/platform/simulator/simulator_settings.hpp"

namespace striate::simulator {

/// The base's motor controller: commands arrive late, speeds change as fast as the motors can, and
/// without a command for a while the wheels stop.
class Drive {
 public:
  Drive(const RobotDescription& robot, const BaseSettings& settings)
      : robot_(robot), settings_(settings) {}

  void command(double now_s, const MotorCommand& command);
  /// Wheels to a stand as fast as they can, no matter what is under way.
  void stop();
  /// One step on. `really_forward_m_s` and `really_turn_rad_s` is what the last step achieved.
  void step(double now_s, double dt_s, double really_forward_m_s, double really_turn_rad_s);

  [[nodiscard]] double forward_m_s() const { return forward_m_s_; }
  [[nodiscard]] double turn_rad_s() const { return turn_rad_s_; }
  [[nodiscard]] bool stalled() const { return stalled_; }
  /// The newest command that has reached the motors.
  [[nodiscard]] const MotorCommand& in_force() const { return in_force_; }

 private:
  struct Pending {
    double due_s = 0.0;
    MotorCommand command;
  };
  void feel_stall(double dt_s, double really_forward_m_s, double really_turn_rad_s);

  RobotDescription robot_;
  BaseSettings settings_;
  std::deque<Pending> pending_;
  MotorCommand in_force_;
  double last_arrival_s_ = 0.0;
  double forward_m_s_ = 0.0;
  double turn_rad_s_ = 0.0;
  double pushing_s_ = 0.0;
  bool stalled_ = false;
};

}  // namespace striate::simulator
