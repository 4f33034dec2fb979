#pragma once

#include <algorithm>
#include <vector>

/// Semi-global matching's path costs, plainly (Hirschmueller 2008, equation 13), saturated at 255
/// as the vector code's 8 bits are.
namespace striate::reference {

/// costs[(y * width + x) * disparities + d]
struct CostCube {
  int width = 0, height = 0, disparities = 0;
  std::vector<int> values;
  CostCube(int w, int h, int d)
      : width(w), height(h), disparities(d), values(static_cast<std::size_t>(w * h * d)) {}
  int& at(int y, int x, int d) {
    return values[static_cast<std::size_t>((y * width + x) * disparities + d)];
  }
  [[nodiscard]] int at(int y, int x, int d) const {
    return values[static_cast<std::size_t>((y * width + x) * disparities + d)];
  }
};

/// Costs along the path that comes from (y - dy, x - dx).
inline CostCube path_costs(const CostCube& costs, int dy, int dx, int p1, int p2) {
  CostCube result(costs.width, costs.height, costs.disparities);
  const int last = costs.disparities - 1;
  for (int n = 0; n < costs.height; ++n) {
    for (int m = 0; m < costs.width; ++m) {
      const int y = dy >= 0 ? n : costs.height - 1 - n;
      const int x = dx >= 0 ? m : costs.width - 1 - m;
      const int v = y - dy, u = x - dx;
      const bool starts = v < 0 || u < 0 || v >= costs.height || u >= costs.width;
      int floor = 255;
      for (int d = 0; d <= last && !starts; ++d) floor = std::min(floor, result.at(v, u, d));
      for (int d = 0; d <= last; ++d) {
        int extra = 0;
        if (!starts) {
          extra = std::min(result.at(v, u, d), std::min(255, floor + p2));
          if (d > 0) extra = std::min(extra, result.at(v, u, d - 1) + p1);
          if (d < last) extra = std::min(extra, result.at(v, u, d + 1) + p1);
          extra -= floor;
        }
        result.at(y, x, d) = std::min(255, costs.at(y, x, d) + extra);
      }
    }
  }
  return result;
}

}  // namespace striate::reference
