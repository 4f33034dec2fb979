#pragma once

#include <cmath>

/// Speed and way of a stop: v latency + v^2 / 2a = way. Any one unit of length will do, metres or
/// millimetres, the same for way, speed and deceleration.
namespace striate {

/// The greatest speed from which one still stands within `way`, >= 0; 0 where `way` <= 0.
/// @param deceleration above 0, per second squared
/// @param latency_s seconds from the decision to the brake's first effect, >= 0
[[nodiscard]] inline double stopping_speed(double way, double deceleration, double latency_s) {
  if (way <= 0.0) return 0.0;
  const double lag = deceleration * latency_s;
  return std::sqrt(lag * lag + 2.0 * deceleration * way) - lag;
}

/// The way that a stop from `speed` takes; the inverse of `stopping_speed`.
[[nodiscard]] inline double stopping_way(double speed, double deceleration, double latency_s) {
  const double v = std::abs(speed);
  return v * latency_s + v * v / (2.0 * deceleration);
}

}  // namespace striate
