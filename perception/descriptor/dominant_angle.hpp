#pragma once

#include <array>
#include <cstddef>

#include "striate/perception/descriptor/pooling_kernels.hpp"

namespace striate::perception {

/// Up to two directions, the stronger first, radians from +u towards +v.
struct DominantAngles {
  std::array<double, 2> angle_rad{};
  std::size_t count = 1;
};

/// Where the odd cells around a place see it grow brighter. At every pixel the odd responses of all
/// orientations, summed as vectors, point in one direction; a histogram of these, weighted by their
/// length and by a Gaussian around the place, is smoothed, and its highest peak is taken. A second
/// peak of at least 0.8 of its height is taken as well, as SIFT does (Lowe 2004): which of the two
/// is higher, the next image may see the other way round.
/// @param at the pixel of the place; readable 6 px before and 9 px behind it in u and v.
/// @param u, v where between pixels the place is, 0..1.
/// Without any response: one direction, 0.
[[nodiscard]] DominantAngles dominant_angles(const pooling_kernels::OddWindow& at, double u,
                                             double v);

}  // namespace striate::perception
