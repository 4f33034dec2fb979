#pragma once

#include <cmath>
#include <optional>

#include "striate/base/time.hpp"
#include "striate/platform/interface/motor_command.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::remote {

/// Whether a robot follows what it is told, by what its odometry says: the only answer that a
/// robot behind ROS gives. One that does not move soon after it was told to hears late, tells late,
/// or is driven by somebody else; then it holds until somebody who has looked at it resets it.
/// Pure.
class MotionEcho {
 public:
  /// @param within the way there and back, and the robot's own time to begin
  explicit MotionEcho(Duration within) : within_(within) {}

  /// What is published. Call many times a second.
  void commanded(const MotorCommand& command, TimePoint now) {
    const bool moves =
        std::abs(command.forward_m_s) > kTold_m_s || std::abs(command.turn_rad_s) > kTold_rad_s;
    if (!moves) {
      told_at_.reset();
      followed_ = false;
      return;
    }
    if (!told_at_) told_at_ = now;
    holds_ = holds_ || (!followed_ && now - *told_at_ > within_);
  }
  /// The newest odometry.
  void felt(const Odometry& odometry) {
    followed_ = followed_ || std::abs(odometry.forward_m_s) > kFelt_m_s ||
                std::abs(odometry.turn_rad_s) > kFelt_rad_s;
  }
  void reset() { *this = MotionEcho(within_); }
  [[nodiscard]] bool holds() const { return holds_; }

 private:
  // By hand: slower may be less than a motor turns by.
  static constexpr double kTold_m_s = 0.05;
  static constexpr double kTold_rad_s = 0.1;
  // By hand: what odometry of a robot that stands does not show.
  static constexpr double kFelt_m_s = 0.02;
  static constexpr double kFelt_rad_s = 0.03;
  Duration within_;
  std::optional<TimePoint> told_at_;
  bool followed_ = false;
  bool holds_ = false;
};

}  // namespace striate::remote
