#pragma once

#include <array>
#include <cstdint>

#include "perception/stereo/sweep_kernels.hpp"
#include "perception/v1/plane.hpp"

namespace striate {

/// A volume [line][disparity][position]: line y holds rows y * disparities ... of a plane.
template <class T>
struct Volume {
  Plane<T> plane;
  int disparities = 0;
  void resize(int lines, int disparity_count, int width) {
    disparities = disparity_count;
    plane.resize(width, lines * disparity_count, 1, 0);
  }
  [[nodiscard]] T* line(int y) { return plane.row(y * disparities); }
  [[nodiscard]] const T* line(int y) const { return plane.row(y * disparities); }
};

/// Semi-global smoothing of matching costs along 8 paths (Hirschmueller 2008). Keeps its buffers.
class SemiGlobal {
 public:
  SemiGlobal(int small_penalty, int large_penalty)
      : small_penalty_(small_penalty), large_penalty_(large_penalty) {}

  /// @param costs [row][disparity][column].
  /// @param sums gets the sum of the 8 path costs, same layout.
  void smooth(const Volume<std::uint8_t>& costs, int height, Volume<std::uint16_t>& sums);

 private:
  void sweep(const Volume<std::uint8_t>& costs, int lines, bool three, Volume<std::uint16_t>& sums);

  int small_penalty_;
  int large_penalty_;
  std::array<std::array<Volume<std::uint8_t>, 3>, 2> path_lines_;
  std::array<std::array<Plane<std::uint8_t>, 3>, 2> smallest_;
  Volume<std::uint8_t> turned_costs_;
  Volume<std::uint16_t> turned_sums_;
};

}  // namespace striate
