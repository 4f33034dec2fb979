#pragma once

#include <cmath>

#include "striate/perception/percept.hpp"
#include "striate/platform/interface/senses.hpp"

/// Hand-made senses and percepts for tests of memory.
namespace striate::looks {

inline TimePoint at_ms(int milliseconds) {
  return TimePoint(std::chrono::milliseconds(milliseconds));
}

inline Senses senses_at(int milliseconds, const Pose2& odometry) {
  Senses senses;
  senses.now = at_ms(milliseconds);
  senses.odometry.stamp = senses.now;
  senses.odometry.pose = odometry;
  return senses;
}

/// 161 columns over 43 degrees about `middle_rad`; nothing known yet.
inline perception::Percept blank_percept(int milliseconds, double middle_rad = 0.0) {
  perception::Percept percept;
  percept.stamp = at_ms(milliseconds);
  percept.valid = true;
  percept.light_level = 0.5;
  percept.disparity.focal_px = 203.0;
  percept.disparity.baseline_m = 0.12;
  percept.columns.resize(161);
  for (int u = 0; u <= 160; ++u) {
    percept.columns[static_cast<std::size_t>(u)].bearing_rad =
        middle_rad + std::atan((80 - u) / 203.0);
  }
  return percept;
}

inline void see_floor(perception::Percept& percept, double from_m, double to_m) {
  for (perception::Column& column : percept.columns) {
    column.free_from_m = from_m;
    column.free_to_m = to_m;
    column.free_confidence = 0.9;
  }
}

/// Something in all columns within `half_rad` of `bearing_rad`.
inline void see_thing(perception::Percept& percept, double bearing_rad, double half_rad,
                      double distance_m) {
  for (perception::Column& column : percept.columns) {
    if (std::abs(column.bearing_rad - bearing_rad) > half_rad) continue;
    column.obstacle_m = distance_m;
    column.obstacle_confidence = 0.9;
    column.free_to_m = std::min(column.free_to_m, distance_m - 0.1);
  }
}

}  // namespace striate::looks
