#pragma once

#include <optional>

#include "striate/base/time.hpp"
#include "striate/platform/interface/motor_command.hpp"

namespace striate::remote {

/// Notices that the program did not run, or that nobody decided in the midst of motion, and then
/// holds until somebody who has looked at the robot resets it. Pure.
class GapWatch {
 public:
  /// @param longest_gap between two looks; @param command_gap after a command that is motion
  GapWatch(Duration longest_gap, Duration command_gap)
      : longest_gap_(longest_gap), command_gap_(command_gap) {}

  /// Call many times within `longest_gap`, and before anything is sent.
  void look(TimePoint now) {
    holds_ = holds_ || (looked_at_ && now - *looked_at_ > longest_gap_);
    looked_at_ = now;
  }
  void commanded(const MotorCommand& command, TimePoint now) {
    look(now);
    holds_ = holds_ || (moved_at_ && now - *moved_at_ > command_gap_);
    moved_at_.reset();
    if (command.forward_m_s != 0.0 || command.turn_rad_s != 0.0) moved_at_ = now;
  }
  void reset() {
    holds_ = false;
    looked_at_.reset();
    moved_at_.reset();
  }
  [[nodiscard]] bool holds() const { return holds_; }

 private:
  Duration longest_gap_;
  Duration command_gap_;
  std::optional<TimePoint> looked_at_;
  std::optional<TimePoint> moved_at_;
  bool holds_ = false;
};

}  // namespace striate::remote
