#pragma once

#include "striate/perception/v1/plane.hpp"

namespace striate::perception::stereo_kernels {

/// out = median of the 5x5 neighbourhood; beside the image the nearest pixel inside counts.
/// @param values with a margin of at least 2 columns, which is filled here.
/// @param out resized to the same size.
void median_5x5(Plane<std::uint8_t>& values, Plane<std::uint8_t>& out);

}  // namespace striate::perception::stereo_kernels
