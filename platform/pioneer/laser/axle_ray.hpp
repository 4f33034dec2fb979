#pragma once

#include <cmath>

#include "platform/interface/geometry.hpp"
#include "platform/interface/senses.hpp"

namespace striate::pioneer {

/// A ray of a laser that stands `forward_m` before the axle, as it is seen from the axle. A ray
/// without echo (infinite) keeps its bearing.
[[nodiscard]] inline RangeReading axle_ray(double forward_m, double bearing_rad, double range_m) {
  if (!std::isfinite(range_m)) return {bearing_rad, range_m};
  const Point2 hit = to_outer({forward_m, 0.0, bearing_rad}, Point2{range_m, 0.0});
  return {std::atan2(hit.y_m, hit.x_m), std::hypot(hit.x_m, hit.y_m)};
}

}  // namespace striate::pioneer
