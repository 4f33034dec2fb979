#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::evaluation {

/// Distance of the nearest visible thing that stands in each column; +inf for none.
inline std::vector<double> true_columns(const cv::Mat1f& depth,
                                        const perception::DisparityMap& camera,
                                        const HeadPose& head, const RobotDescription& robot,
                                        double lowest_m = 0.06) {
  constexpr double kHighest_m = 1.4;
  constexpr int kFewestPixels = 3;  // of a true thing, else it is an edge
  const perception::ViewGeometry geometry(camera, head, robot);
  std::vector<double> nearest(depth.cols, perception::kNothing_m);
  for (int u = 0; u < depth.cols; ++u) {
    std::vector<double> ranges;
    for (int v = 0; v < depth.rows; ++v) {
      if (!std::isfinite(depth(v, u))) continue;
      const perception::SpacePoint p =
          geometry.point(u, v, geometry.focal_baseline() / depth(v, u));
      if (p.z_m < lowest_m || p.z_m > kHighest_m) continue;
      ranges.push_back(std::hypot(p.x_m, p.y_m));
    }
    if (ranges.size() < kFewestPixels) continue;
    std::nth_element(ranges.begin(), ranges.begin() + kFewestPixels - 1, ranges.end());
    nearest[u] = ranges[kFewestPixels - 1];
  }
  return nearest;
}

}  // namespace striate::evaluation
