#pragma once

#include <cstdint>

#include "striate/perception/descriptor/dense_descriptor.hpp"

/// The paper's matching of one image row; vector code, dispatched at run time, integer.
namespace striate::perception::stereo_kernels {

inline constexpr int kReachBack = 72;  ///< bytes before column 0 that are read (and not used)

/// Rows of work space: both rows' bytes as two nibbles each, see match_tables-inl.hpp.
inline constexpr int kNibbleRows = 4 * kDescriptorPoints + 2;

struct MatchRow {
  DescriptorRow left;
  DescriptorRow right;                    ///< readable from -kReachBack on
  const std::uint8_t* outside = nullptr;  ///< outside[x] is 255 for x < 0, else 0; likewise
  int width = 0;
  int candidates = 0;                ///< disparities 0 .. candidates - 1, at most 256
  std::uint8_t* smallest = nullptr;  ///< room for the width rounded up to 64
  std::uint8_t* best = nullptr;      ///< likewise
  std::uint8_t* nibbles = nullptr;   ///< work space, kNibbleRows times as much
};

/// best[x] = the disparity d < candidates, d <= x, for which left pixel x and right pixel x - d
/// differ in the fewest bits; of equal ones the smallest. 255 and 256 bits count alike.
/// smallest[x] = that number of bits.
void best_matches(const MatchRow& row);

}  // namespace striate::perception::stereo_kernels
