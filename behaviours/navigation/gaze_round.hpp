#pragma once

#include "striate/behaviours/control/wish.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// The head goes from one side to the other and then from salient region to salient region,
/// resting on each. Inhibition of return in short-term memory keeps it from the same region twice.
class GazeRound {
 public:
  /// @param sweep_rad how far to each side, @param dwell_s how long it rests, @param regions how
  /// many salient regions at most
  GazeRound(double sweep_rad, double dwell_s, int regions, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory);
  /// Sets the head of `wish`; false once the round is over.
  bool tick(const memory::ShortTermMemory& memory, Wish& wish);

 private:
  bool aim_at_next(const memory::ShortTermMemory& memory);
  void follow_region(const memory::ShortTermMemory& memory);

  double sweep_rad_;
  double dwell_s_;
  int regions_;
  double max_pan_rad_;
  int step_ = -1;
  double pan_rad_ = 0.0;
  int region_ = 0;  ///< looked at now; 0: a side
  TimePoint aimed_{};
  TimePoint arrived_{};
  bool there_ = false;
};

}  // namespace striate::behaviours
