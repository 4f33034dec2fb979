#pragma once

#include <chrono>
#include <optional>

#include "striate/base/time.hpp"

namespace striate::app {

/// Holds a simulated or recorded robot back to the time on the wall, for whoever looks on. Changes
/// nothing of what it does.
class Pace {
 public:
  using Steady = std::chrono::steady_clock;

  /// @param speed 1: real time, 2: twice as fast. 0: as fast as it can
  explicit Pace(double speed) : speed_(speed) {}

  /// When the cycle of that mission time is due. One that is late is due at once, and those after
  /// it are not hurried.
  [[nodiscard]] Steady::time_point due(TimePoint mission_time, Steady::time_point now) {
    if (speed_ <= 0.0) return now;
    if (begun_) {
      const Steady::time_point due =
          *begun_ + std::chrono::duration_cast<Steady::duration>(
                        std::chrono::duration<double>(to_seconds(mission_time - first_) / speed_));
      if (due >= now) return due;
    }
    begun_ = now;
    first_ = mission_time;
    return now;
  }

 private:
  double speed_;
  std::optional<Steady::time_point> begun_;  ///< when `first_` was
  TimePoint first_;
};

}  // namespace striate::app
