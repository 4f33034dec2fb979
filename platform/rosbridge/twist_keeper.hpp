#pragma once

#include <sys/types.h>

#include "striate/platform/rosbridge/bridge_settings.hpp"

namespace striate::rosbridge {

/// A process and a rosbridge client of its own that says zero on `cmd_vel` when this program dies
/// of anything, or is silent for longer than it may be while the robot moves: many robots drive on
/// with the last command that they were given.
class TwistKeeper {
 public:
  /// Where no process can be had there is none: then the robot's own deadline is what is left.
  explicit TwistKeeper(const BridgeSettings& settings);
  /// An end on purpose: nothing more is said.
  ~TwistKeeper();
  TwistKeeper(const TwistKeeper&) = delete;
  TwistKeeper& operator=(const TwistKeeper&) = delete;

  /// A sign of life, at least each 100 ms. @param moves what was published is no stand
  void hear(bool moves) noexcept;

 private:
  int line_ = -1;
  pid_t keeper_ = -1;
};

}  // namespace striate::rosbridge
