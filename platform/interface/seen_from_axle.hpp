#pragma once

#include <cmath>

#include "striate/platform/interface/senses.hpp"

namespace striate {

/// An echo that a range finder at `sensor` (robot frame) measured straight ahead, as seen from the
/// axle. Nothing within range (+inf) stays so, in the sensor's direction.
[[nodiscard]] inline RangeReading seen_from_axle(const Pose2& sensor, double distance_m) {
  if (!std::isfinite(distance_m)) return {sensor.heading_rad, distance_m};
  const Point2 hit = transform(sensor, Point2{distance_m, 0.0});
  return {std::atan2(hit.y_m, hit.x_m), std::hypot(hit.x_m, hit.y_m)};
}

}  // namespace striate
