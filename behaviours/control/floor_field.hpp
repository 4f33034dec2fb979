#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/memory/short_term/local_grid.hpp"

namespace striate::behaviours {

/// How far every patch of remembered floor is from what stands on it: the distance transform of
/// the evidence grid. A speck of one or two occupied patches counts only with strong evidence:
/// single wrong matches are common, and thin things are seen again and again.
class FloorField {
 public:
  static constexpr double kFar_m = 10.0;  ///< beyond the field's corners (7.6 m): nothing near
  static constexpr int kReach = 108;  ///< cells each way, 5.4 m: what is planned over, and a little

  FloorField();
  void update(const memory::LocalGrid& grid);

  /// Distance to the nearest edge of anything; kFar_m outside the field.
  [[nodiscard]] double clearance_m(Point2 odometry) const;
  /// Distance to the nearest floor that is not seen free: an edge of knowledge may hide a wall too
  /// plain to see. Never more than `clearance_m`; 0 on unknown floor.
  [[nodiscard]] double seen_clearance_m(Point2 odometry) const;
  [[nodiscard]] memory::CellState state(Point2 odometry) const;

 private:
  [[nodiscard]] double metres(const cv::Mat1f& cells, Point2 odometry) const;
  [[nodiscard]] bool inside(Point2 odometry, int& column, int& row) const;
  memory::GridCell first_;
  cv::Mat1b states_;  // CellState
  cv::Mat1b open_;    // 0 where something stands
  cv::Mat1b seen_;    // 0 where floor is not seen free
  cv::Mat1f distance_cells_;
  cv::Mat1f seen_cells_;
  cv::Mat1b round_;
};

}  // namespace striate::behaviours
