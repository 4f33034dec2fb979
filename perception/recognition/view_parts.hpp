#pragma once

#include <cmath>
#include <cstddef>

#include "striate/base/index_within.hpp"
#include "striate/perception/recognition/pose.hpp"

namespace striate::perception {

/// Of a view cut into `across` x `across` parts, row by row, the one that a place lies in.
[[nodiscard]] inline std::size_t part_of_view(const KeypointFrame& place, double width_px,
                                              double height_px, int across) {
  const int x = round_within(std::floor(across * place.u_px / width_px), 0, across - 1);
  const int y = round_within(std::floor(across * place.v_px / height_px), 0, across - 1);
  return static_cast<std::size_t>(y * across + x);
}

}  // namespace striate::perception
