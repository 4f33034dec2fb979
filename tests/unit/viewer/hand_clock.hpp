#pragma once

#include "striate/base/time.hpp"

namespace striate::viewer::foxglove {

/// A clock that a test sets.
class HandClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return time; }
  TimePoint time{std::chrono::seconds(100)};
};

inline TimePoint mission_ms(int ms) {
  return TimePoint(std::chrono::milliseconds(ms));
}

}  // namespace striate::viewer::foxglove
