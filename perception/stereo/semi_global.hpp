#pragma once

#include <array>
#include <cstdint>

#include "striate/perception/stereo/sweep_kernels.hpp"
#include "striate/perception/stereo/volume.hpp"

namespace striate::perception {

/// One row of smoothed costs, [disparity][column]; valid until the next row is finished.
struct SmoothedCosts {
  const std::uint16_t* steep_sums = nullptr;  ///< of the six vertical and diagonal paths
  int sum_stride = 0;
  /// Means of the two horizontal paths, rounded up: kept in 8 bits for speed; half a bit of Hamming
  /// distance at most is lost.
  const std::uint8_t* level_means = nullptr;
  int mean_stride = 0;
};

/// Semi-global smoothing of matching costs along 8 paths (Hirschmueller 2008). Keeps its buffers.
///
/// Row by row, so that what was just written is still in the cache: on the way down the paths from
/// above; on the way up, a strip of rows at a time, the horizontal ones and then those from below,
/// and each row is complete. Vertical and diagonal paths go from row to row with the columns in the
/// lanes of a vector; for the horizontal ones a strip is turned, its rows in the lanes.
class SemiGlobal {
 public:
  SemiGlobal(int small_penalty, int large_penalty)
      : small_penalty_(small_penalty), large_penalty_(large_penalty) {}

  /// @param costs [row][disparity][column], of this size; filled row by row before `take_row`. Must
  /// outlive the last `finish_row`.
  void begin(const Volume<std::uint8_t>& costs, int height);
  /// All rows once, from the first to the last.
  void take_row(int y);
  /// All rows once, from the last to the first.
  [[nodiscard]] SmoothedCosts finish_row(int y);

 private:
  void sweep_steep(int y, bool downwards);
  void sweep_level(int y, int rows);
  [[nodiscard]] stereo_kernels::PathLine path_line(std::size_t side, std::size_t direction);
  [[nodiscard]] stereo_kernels::PathLine strip_line(std::size_t side);
  void start_paths();
  void start_strip_paths();
  void sweep_rightwards(int x);
  void sweep_leftwards(int x);
  [[nodiscard]] stereo_kernels::SweepStep strip_step(int x) const;

  int small_penalty_;
  int large_penalty_;
  const Volume<std::uint8_t>* costs_ = nullptr;
  int height_ = 0;
  std::array<std::array<Volume<std::uint8_t>, 3>, 2> path_lines_;  ///< [this line, before]
  std::array<std::array<Plane<std::uint8_t>, 3>, 2> smallest_;
  Volume<std::uint16_t> from_above_;  ///< sums of the three paths from above
  Volume<std::uint16_t> sums_;        ///< of the row that was finished last
  Volume<std::uint8_t> level_means_;  ///< of a strip
  /// A strip, one row a column of the image: [disparity][row of the strip].
  Plane<std::uint8_t> strip_costs_, strip_means_;
  std::array<Plane<std::uint8_t>, 2> strip_paths_;  ///< row 0: paths, row 1: their smallest
};

}  // namespace striate::perception
