#pragma once

#include "perception/v1/plane.hpp"

namespace striate {

/// A volume [line][disparity][position]: line y holds rows y * disparities ... of a plane.
template <class T>
struct Volume {
  Plane<T> plane;
  int disparities = 0;
  void resize(int lines, int disparity_count, int width) {
    disparities = disparity_count;
    plane.resize(width, lines * disparity_count, kMargin, 0);
  }
  [[nodiscard]] T* line(int y) { return plane.row(y * disparities); }
  [[nodiscard]] const T* line(int y) const { return plane.row(y * disparities); }

  static constexpr int kMargin = 2;  ///< elements usable on either side of a row
};

}  // namespace striate
