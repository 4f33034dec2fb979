#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "striate/perception/descriptor/pooling_kernels.hpp"

/// The vector code of dominant_angles(), dispatched at run time. Single precision without fused
/// operations: the same bits on every instruction set.
namespace striate::perception::direction_kernels {

/// Looked at before the place, in u and v: 3 sigma of dominant_angle.cpp
inline constexpr int kBefore_px = 6;
/// 6 before, the place's own pixel, 7 behind: the place lies up to 1 px behind its pixel
inline constexpr int kSide_px = 14;
inline constexpr int kColumns = 16;  ///< of which the last two weigh nothing
inline constexpr int kBins = 36;     ///< of 10 degrees, from +u towards +v

/// A square of weights as a product.
struct Weights {
  std::array<float, kColumns> across{};
  std::array<float, kSide_px> down{};
};

/// Of every pixel, row by row: the two bins that its direction lies between, and what each gets of
/// its weighted length.
struct Shares {
  std::array<std::int32_t, static_cast<std::size_t>(kSide_px*kColumns)> bin, next_bin;
  std::array<float, static_cast<std::size_t>(kSide_px*kColumns)> share, next_share;
};

/// The odd responses of all orientations, summed as vectors.
/// @param at the pixel of the place, kBefore_px behind the first one.
void share_directions(const pooling_kernels::OddWindow& at, const Weights& weights, Shares& out);

}  // namespace striate::perception::direction_kernels
