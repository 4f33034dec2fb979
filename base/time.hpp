#pragma once

#include <chrono>

namespace striate {

/// Time as the body tells it: simulated or real. Starts at zero when the body starts.
struct BodyTime {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<BodyTime, duration>;
  static constexpr bool is_steady = true;
};

using Duration = BodyTime::duration;
using TimePoint = BodyTime::time_point;

/// The injected clock: nothing else in Striate asks what time it is.
class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual TimePoint now() const = 0;
};

[[nodiscard]] constexpr double to_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

[[nodiscard]] constexpr double to_seconds(TimePoint time) {
  return to_seconds(time.time_since_epoch());
}

[[nodiscard]] constexpr Duration from_seconds(double seconds) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace striate
