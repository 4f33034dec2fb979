#pragma once

#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// Half of the corridor's width at a place along it, widenings and narrowings counted.
[[nodiscard]] inline double half_width_m(const World& world, double along_m) {
  for (const Widening& other : world.widenings) {
    if (along_m >= other.from_m && along_m <= other.to_m) return other.width_m / 2;
  }
  return world.width_m / 2;
}

}  // namespace striate::simulator
