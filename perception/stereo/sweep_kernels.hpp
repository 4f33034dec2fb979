#pragma once

#include <array>
#include <cstdint>

/// One step of semi-global matching's dynamic programming (Hirschmueller 2008, equation 13);
/// vector code, dispatched at run time, integer. Lanes are the positions along one picture line;
/// paths come from the line before, straight or by one position askew.
namespace striate::stereo_kernels {

/// The state of one path direction along a line: `costs[d * stride + x]` and their minimum over d.
/// Positions -1 and `width` are zero: a path that enters there starts anew.
struct PathLine {
  std::uint8_t* costs = nullptr;
  std::uint8_t* smallest = nullptr;
};

/// Directions that are swept together: they come from x - 1, x and x + 1 of the line before.
struct SweepStep {
  const std::uint8_t* costs = nullptr;  ///< matching costs of this line, [d][x]
  std::array<PathLine, 3> before;       ///< of the line before; null: not swept
  std::array<PathLine, 3> here;
  std::uint16_t* sums = nullptr;  ///< [d][x]; path costs are added, or stored when `first`
  bool first = false;
  int stride = 0;      ///< elements between disparities, in the costs and the paths
  int sum_stride = 0;  ///< in the sums
  int width = 0;
  int disparities = 0;
  int small_penalty = 0;
  int large_penalty = 0;
};

/// All three directions; `before` of each must be given.
void sweep_three(const SweepStep& step);

/// The straight direction only (before[1], here[1]).
void sweep_straight(const SweepStep& step);

}  // namespace striate::stereo_kernels
