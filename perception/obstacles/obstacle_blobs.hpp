#pragma once

#include <vector>

#include "striate/perception/obstacles/column_scan.hpp"

namespace striate::perception {

/// One column's obstacle, ready to be joined with its neighbours.
struct ColumnHit {
  bool found = false;
  double level_px = 0.0;  ///< level disparity
  Point2 at;              ///< robot frame
  double height_m = 0.0;  ///< of its highest part seen
  double lowest_m = 0.0;  ///< of its lowest part seen
  double confidence = 0.0;
};

/// Joins neighbouring columns at about the same distance. Nearest first.
[[nodiscard]] std::vector<Obstacle> join_columns(const std::vector<ColumnHit>& hits);

}  // namespace striate::perception
