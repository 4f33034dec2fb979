#pragma once

#include "striate/behaviours/control/wish.hpp"

namespace striate::behaviours {

/// A stretch of straight driving, forward or back: holds the heading it began with, slows down
/// before its end, and fails when something keeps it from going on. Shared by drive_straight and
/// back_up.
class StraightLine {
 public:
  /// `distance_m` > 0; `speed_m_s` negative drives back.
  StraightLine(double distance_m, double speed_m_s)
      : distance_m_(distance_m), speed_m_s_(speed_m_s) {}
  void start(const memory::ShortTermMemory& memory);
  Wish tick(const memory::ShortTermMemory& memory);

 private:
  double distance_m_;
  double speed_m_s_;
  Pose2 from_;
  double farthest_m_ = 0.0;
  TimePoint farthest_at_{};
};

}  // namespace striate::behaviours
