#pragma once

#include <cstdint>
#include <vector>

#include "striate/perception/v1/plane.hpp"

namespace striate::perception {

struct GridPoint {
  int x = 0;
  int y = 0;
  std::uint16_t value = 0;
};

/// Largest value of a plane; vectorised. 0 for an empty one.
[[nodiscard]] std::uint16_t largest_value(const Plane<std::uint16_t>& plane);

/// Strict maxima in 3x3 above `least`, at least `border` >= 1 pixels inside; row by row.
void find_strict_maxima(const Plane<std::uint16_t>& plane, int border, std::uint16_t least,
                        std::vector<GridPoint>& out);

}  // namespace striate::perception
