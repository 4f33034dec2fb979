#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// One step of semi-global matching's dynamic programming (Hirschmueller 2008, equation 13);
/// vector code, dispatched at run time, integer. Lanes are the positions along one image line;
/// paths come from the line before, straight or by one position askew.
namespace striate::perception::stereo_kernels {

/// The state of one path direction along a line: `costs[d * stride + x]` and their minimum over d.
/// Positions -1 and `width` are zero: a path that enters there starts anew.
struct PathLine {
  std::uint8_t* costs = nullptr;
  std::uint8_t* smallest = nullptr;
};

/// One line of the image. All arrays are [disparity][position].
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
  const std::uint16_t* others = nullptr;  ///< sums of other paths; null: none
  std::uint16_t* sums = nullptr;          ///< gets these and the three path costs
  int sum_stride = 0;                     ///< of both
};
void sweep_three(const SweepStep& step, const ThreePaths& paths);

/// Rows of the image whose horizontal paths are followed together, in the lanes of a vector: few
/// enough that the turned strip stays in the cache.
inline constexpr int kStripRows = 16;

/// The straight direction only; the width is kStripRows.
struct StraightPath {
  PathLine before, here;
  /// Not null: gets the mean (rounded up) of itself and the path costs of this line.
  std::uint8_t* average = nullptr;
};
void sweep_straight(const SweepStep& step, const StraightPath& path);

/// Part of a volume [line][disparity][position].
template <class T>
struct VolumePart {
  T* first = nullptr;
  std::ptrdiff_t line = 0;  ///< elements from line to line
  int stride = 0;           ///< from disparity to disparity
};

/// How much of a volume is turned.
struct TurnShape {
  int lines = 0;
  int width = 0;
  int disparities = 0;
};

/// to[x][d][y] = from[y][d][x]. Rows of `to` must have room for the lines rounded up to 16; what
/// is written behind the last line is of no meaning.
void turn(const VolumePart<const std::uint8_t>& from, const TurnShape& shape,
          const VolumePart<std::uint8_t>& to);

}  // namespace striate::perception::stereo_kernels
