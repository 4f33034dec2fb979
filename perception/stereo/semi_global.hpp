#pragma once

#include <array>
#include <cstdint>

#include "perception/stereo/sweep_kernels.hpp"
#include "perception/stereo/volume.hpp"

namespace striate {

/// Semi-global smoothing of matching costs along 8 paths (Hirschmueller 2008). Keeps its buffers.
///
/// Vertical and diagonal paths go from row to row with the columns in the lanes of a vector; for
/// the two horizontal paths the volume is turned, so that they too go from line to line.
class SemiGlobal {
 public:
  SemiGlobal(int small_penalty, int large_penalty)
      : small_penalty_(small_penalty), large_penalty_(large_penalty) {}

  /// @param costs [row][disparity][column].
  void smooth(const Volume<std::uint8_t>& costs, int height);

  /// Sums of the path costs of the six vertical and diagonal paths, [row][disparity][column].
  [[nodiscard]] const Volume<std::uint16_t>& steep_sums() const { return steep_sums_; }
  /// Means of the two horizontal paths, rounded up: kept in 8 bits for speed; half a bit of
  /// Hamming distance at most is lost.
  [[nodiscard]] const Volume<std::uint8_t>& level_means() const { return level_means_; }

 private:
  void sweep_steep(const Volume<std::uint8_t>& costs, int height);
  void sweep_level(int width);
  [[nodiscard]] stereo_kernels::PathLine path_line(std::size_t side, std::size_t direction);
  void start_paths(int width, int disparities);

  int small_penalty_;
  int large_penalty_;
  std::array<std::array<Volume<std::uint8_t>, 3>, 2> path_lines_;  ///< [this line, before]
  std::array<std::array<Plane<std::uint8_t>, 3>, 2> smallest_;
  Volume<std::uint16_t> steep_sums_;
  Volume<std::uint8_t> turned_costs_;
  Volume<std::uint8_t> turned_means_;
  Volume<std::uint8_t> level_means_;
};

}  // namespace striate
