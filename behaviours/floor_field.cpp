#include "behaviours/floor_field.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace striate {
namespace {

constexpr int kSide = LocalGrid::kSide;
constexpr float kStrongAlone = 2.2F;  // log-odds
constexpr double kBlockAtOnce_m = 1.0;

}  // namespace

FloorField::FloorField()
    : states_(kSide, kSide, static_cast<std::uint8_t>(FloorState::unknown)),
      open_(kSide, kSide, std::uint8_t{255}),
      distance_cells_(kSide, kSide, 1e3F) {}

void FloorField::update(const LocalGrid& grid, Point2 robot) {
  first_ = grid.first();
  for (int row = 0; row < kSide; ++row) {
    std::uint8_t* states = states_[row];
    for (int column = 0; column < kSide; ++column) {
      states[column] = static_cast<std::uint8_t>(grid.state({first_.x + column, first_.y + row}));
    }
  }
  constexpr auto kOccupied = static_cast<std::uint8_t>(FloorState::occupied);
  open_.setTo(255);
  for (int row = 1; row < kSide - 1; ++row) {
    for (int column = 1; column < kSide - 1; ++column) {
      if (states_(row, column) != kOccupied) continue;
      int neighbours = -1;
      for (int v = row - 1; v <= row + 1; ++v) {
        for (int u = column - 1; u <= column + 1; ++u) neighbours += states_(v, u) == kOccupied;
      }
      const GridCell cell{first_.x + column, first_.y + row};
      const Point2 at = LocalGrid::centre_of(cell);
      if (neighbours > 0 || grid.log_odds(cell) > kStrongAlone ||
          std::hypot(at.x_m - robot.x_m, at.y_m - robot.y_m) < kBlockAtOnce_m) {
        open_(row, column) = 0;
      }
    }
  }
  cv::distanceTransform(open_, distance_cells_, cv::DIST_L2, cv::DIST_MASK_5);
}

bool FloorField::inside(Point2 odometry, int& column, int& row) const {
  const GridCell cell = LocalGrid::cell_of(odometry);
  column = cell.x - first_.x;
  row = cell.y - first_.y;
  return column >= 0 && row >= 0 && column < kSide && row < kSide;
}

double FloorField::clearance_m(Point2 odometry) const {
  int column = 0;
  int row = 0;
  if (!inside(odometry, column, row)) return kFar_m;
  const double cells = distance_cells_(row, column) - 0.5;  // to the edge, not the middle
  return std::clamp(cells * LocalGrid::kCell_m, 0.0, kFar_m);
}

FloorState FloorField::state(Point2 odometry) const {
  int column = 0;
  int row = 0;
  return inside(odometry, column, row) ? static_cast<FloorState>(states_(row, column))
                                       : FloorState::unknown;
}

}  // namespace striate
