#include "striate/behaviours/control/floor_field.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace striate::behaviours {
namespace {

constexpr int kSide = 2 * FloorField::kReach;
constexpr int kSkip = memory::LocalGrid::kSide / 2 - FloorField::kReach;

}  // namespace

FloorField::FloorField()
    : states_(kSide, kSide, static_cast<std::uint8_t>(memory::CellState::unknown)),
      open_(kSide, kSide, std::uint8_t{255}),
      seen_(kSide, kSide, std::uint8_t{0}),
      distance_cells_(kSide, kSide, 1e3F),
      seen_cells_(kSide, kSide, 0.0F),
      round_(3, 3, std::uint8_t{1}) {}

void FloorField::update(const memory::LocalGrid& grid) {
  first_ = {grid.first().x + kSkip, grid.first().y + kSkip};
  for (int row = 0; row < kSide; ++row) {
    std::uint8_t* states = states_[row];
    std::uint8_t* seen = seen_[row];
    std::uint8_t* open = open_[row];
    for (int column = 0; column < kSide; ++column) {
      const memory::GridCell cell{first_.x + column, first_.y + row};
      const memory::CellState state = grid.state(cell);
      states[column] = static_cast<std::uint8_t>(state);
      seen[column] = state == memory::CellState::free ? 255 : 0;
      open[column] = state == memory::CellState::occupied && grid.stands(cell) ? 0 : 255;
    }
  }
  cv::distanceTransform(open_, distance_cells_, cv::DIST_L2, cv::DIST_MASK_3);
  // A hole of one patch in seen floor is a column without a match, not a thing.
  cv::morphologyEx(seen_, seen_, cv::MORPH_CLOSE, round_);
  cv::bitwise_and(seen_, open_, seen_);
  cv::distanceTransform(seen_, seen_cells_, cv::DIST_L2, cv::DIST_MASK_3);
}

bool FloorField::inside(Point2 odometry, int& column, int& row) const {
  const memory::GridCell cell = memory::LocalGrid::cell_of(odometry);
  column = cell.x - first_.x;
  row = cell.y - first_.y;
  return column >= 0 && row >= 0 && column < kSide && row < kSide;
}

double FloorField::metres(const cv::Mat1f& cells, Point2 odometry) const {
  int column = 0;
  int row = 0;
  if (!inside(odometry, column, row)) return kFar_m;
  // To the edge of the nearest patch, not to its middle.
  return std::clamp((cells(row, column) - 0.5) * memory::LocalGrid::kCell_m, 0.0, kFar_m);
}

double FloorField::clearance_m(Point2 odometry) const {
  return metres(distance_cells_, odometry);
}

double FloorField::seen_clearance_m(Point2 odometry) const {
  return metres(seen_cells_, odometry);
}

memory::CellState FloorField::state(Point2 odometry) const {
  int column = 0;
  int row = 0;
  return inside(odometry, column, row) ? static_cast<memory::CellState>(states_(row, column))
                                       : memory::CellState::unknown;
}

}  // namespace striate::behaviours
