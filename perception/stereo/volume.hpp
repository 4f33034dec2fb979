#pragma once

#include "striate/perception/v1/plane.hpp"

namespace striate::perception {

/// A volume [line][disparity][position], in the rows of a plane. One row between lines is left
/// out: lines would otherwise lie powers of two apart and fall on each other in the cache.
template <class T>
struct Volume {
  Plane<T> plane;
  int disparities = 0;
  void resize(int lines, int disparity_count, int width) {
    disparities = disparity_count;
    plane.resize(width, lines * (disparity_count + 1), kMargin, 0);
  }
  /// Row of disparity 0 and position 0; disparities are `stride()` elements apart.
  [[nodiscard]] T* line(int y) { return plane.row(y * (disparities + 1)); }
  [[nodiscard]] const T* line(int y) const { return plane.row(y * (disparities + 1)); }

  [[nodiscard]] int stride() const { return plane.stride(); }
  /// Elements from line to line.
  [[nodiscard]] std::ptrdiff_t line_step() const {
    return std::ptrdiff_t{plane.stride()} * (disparities + 1);
  }
  [[nodiscard]] int width() const { return plane.width(); }

  static constexpr int kMargin = 2;  ///< elements usable on either side of a row
};

}  // namespace striate::perception
