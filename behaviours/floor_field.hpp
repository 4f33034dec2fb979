#pragma once

#include <opencv2/core/mat.hpp>

#include "memory/local_grid.hpp"

namespace striate {

/// How far every patch of remembered floor is from what stands on it: the distance transform of
/// the evidence grid. A lone occupied patch counts only with strong evidence, because single
/// wrong matches are common and thin things are seen again and again.
class FloorField {
 public:
  static constexpr double kFar_m = 10.0;

  FloorField();
  void update(const LocalGrid& grid, Point2 robot);

  /// Distance to the nearest edge of anything; kFar_m outside the map.
  [[nodiscard]] double clearance_m(Point2 odometry) const;
  [[nodiscard]] FloorState state(Point2 odometry) const;

 private:
  [[nodiscard]] bool inside(Point2 odometry, int& column, int& row) const;
  GridCell first_;
  cv::Mat1b states_;
  cv::Mat1b open_;  // 0 where something stands
  cv::Mat1f distance_cells_;
};

}  // namespace striate
