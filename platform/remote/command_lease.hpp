#pragma once

#include <cmath>
#include <optional>

#include "striate/base/time.hpp"
#include "striate/platform/interface/motor_command.hpp"

namespace striate::remote {

/// A command that came from elsewhere drives until its lease ends, counted on our steady clock from
/// its arrival: the sender's clock may be wrong, stopped or set.
class CommandLease {
 public:
  explicit CommandLease(Duration lease) : lease_(lease) {}

  /// A speed that is no number is a stop.
  void give(const MotorCommand& command, TimePoint arrived) {
    command_ = command;
    if (!std::isfinite(command.forward_m_s) || !std::isfinite(command.turn_rad_s)) {
      command_.forward_m_s = command_.turn_rad_s = 0.0;
    }
    arrived_ = arrived;
    given_ = true;
  }
  void end() { given_ = false; }
  /// Nothing where nobody has commanded within the lease.
  [[nodiscard]] std::optional<MotorCommand> at(TimePoint now) const {
    if (!given_ || now - arrived_ > lease_) return std::nullopt;
    return command_;
  }

 private:
  Duration lease_;
  MotorCommand command_;
  TimePoint arrived_;
  bool given_ = false;
};

}  // namespace striate::remote
