#pragma once

#include <array>
#include <cstdint>

#include "perception/stereo/volume.hpp"

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

/// One line of the picture. All arrays are [disparity][position].
struct SweepStep {
  const std::uint8_t* costs = nullptr;  ///< matching costs of this line
  int stride = 0;                       ///< between disparities, in costs and paths
  int width = 0;
  int disparities = 0;
  int small_penalty = 0;
  int large_penalty = 0;
};

/// The three directions that come from x - 1, x and x + 1 of the line before.
struct ThreePaths {
  std::array<PathLine, 3> before, here;
  std::uint16_t* sums = nullptr;  ///< the three path costs are added, or stored when `first`
  int sum_stride = 0;
  bool first = false;
};
void sweep_three(const SweepStep& step, const ThreePaths& paths);

/// The straight direction only.
struct StraightPath {
  PathLine before, here;
  /// Not null: gets the mean (rounded up) of itself and the path costs of this line.
  std::uint8_t* average = nullptr;
};
void sweep_straight(const SweepStep& step, const StraightPath& path);

/// How much of a volume is turned.
struct TurnShape {
  int lines = 0;
  int width = 0;
  int disparities = 0;
};

/// to[x][d][y] = from[y][d][x]; `to` has been given its size.
void turn(const Volume<std::uint8_t>& from, const TurnShape& shape, Volume<std::uint8_t>& to);

}  // namespace striate::stereo_kernels
