#pragma once

#include <string>

#include "striate/agent/cognitive_cycle.hpp"

namespace striate::agent {

/// Watches for how long the robot stood at most, and what it said at the end of that.
class LongestStand {
 public:
  explicit LongestStand(TimePoint began) : stands_since_(began) {}

  /// After every cycle.
  void look(const CycleTrace& trace);

  [[nodiscard]] double time_s() const { return longest_s_; }
  [[nodiscard]] std::string why() const;

 private:
  TimePoint stands_since_;
  double longest_s_ = 0.0;
  behaviours::ShortText why_;
  behaviours::LimitReason limit_ = behaviours::LimitReason::none;
};

}  // namespace striate::agent
