#pragma once

#include <array>
#include <cstdint>

/// The best disparity of every pixel of a row; vector code, dispatched at run time, integer.
namespace striate::perception::stereo_kernels {

/// What a row of smoothed costs is made of; all [disparity][column].
struct SmoothedRow {
  const std::uint16_t* steep_sums = nullptr;
  int sum_stride = 0;
  const std::uint8_t* level_means = nullptr;  ///< count twice
  int mean_stride = 0;
  const std::uint8_t* costs = nullptr;    ///< raw matching costs, `mean_stride` apart
  const std::uint8_t* outside = nullptr;  ///< outside[x - d] = 255: no right pixel there
  int width = 0;
  int disparities = 0;
};

/// Where the results go. 65535 stands for "outside the image".
struct WinnerRow {
  std::uint16_t* sums = nullptr;      ///< [disparity][column], `stride` apart: sums of all 8 paths;
                                      ///< columns from the width to the stride must be 65535
  int stride = 0;                     ///< at least width + disparities + 64
  std::uint16_t* best = nullptr;      ///< the disparity with the smallest sum; ties: the smaller
  std::uint16_t* smallest = nullptr;  ///< its sum
  std::uint16_t* second = nullptr;    ///< smallest sum of disparities that differ by 2 or more
  std::uint16_t* raw_second = nullptr;  ///< smallest raw cost of those
  std::uint16_t* right_best = nullptr;  ///< the right image's pixels: their best disparity
};

void find_winners(const SmoothedRow& from, const WinnerRow& to);

/// largest[x] = the largest of the rows' values at x, from -32768; has room for vector steps.
void largest_of_rows(const std::array<const std::int16_t*, 8>& rows, int width,
                     std::int16_t* largest);

}  // namespace striate::perception::stereo_kernels
