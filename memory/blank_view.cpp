#include "memory/blank_view.hpp"

#include <cmath>
#include <vector>

namespace striate {
namespace {

constexpr double kLeastFloor = 0.05;  // share of columns that see floor
constexpr double kLeastTrust = 0.16;  // confidence in things, mean over columns
constexpr int kPatience = 3;          // pictures: one may be blurred
constexpr double kMostPan_rad = 0.8;  // farther round lies the wall that is driven along
constexpr double kFrom_m = 0.40;      // clear of the robot's own outline
constexpr double kTo_m = 1.00;        // farther off the skirting would be in view
constexpr float kGain = 0.6F;
constexpr float kEnough = 2.0F;  // log-odds
constexpr double kStep_m = LocalGrid::kCell_m;

/// Noise alone matches here and there, with little confidence: things count by theirs.
bool is_blank(const std::vector<Column>& columns) {
  double floor = 0.0;
  double trust = 0.0;
  for (const Column& column : columns) {
    if (column.free_to_m > column.free_from_m) ++floor;
    if (std::isfinite(column.obstacle_m)) trust += column.obstacle_confidence;
  }
  const auto all = static_cast<double>(columns.size());
  return floor < kLeastFloor * all && trust < kLeastTrust * all;
}

}  // namespace

void BlankView::see(const Percept& percept, const Pose2& pose, LocalGrid& grid) {
  const auto& columns = percept.columns;
  if (columns.empty()) return;
  blank_pictures_ = is_blank(columns) ? blank_pictures_ + 1 : 0;
  const double left_rad = columns.front().bearing_rad;
  const double right_rad = columns.back().bearing_rad;
  if (blank_pictures_ < kPatience || std::abs(left_rad + right_rad) > 2.0 * kMostPan_rad) return;
  for (double r = kFrom_m; r <= kTo_m; r += kStep_m) {
    for (double b = right_rad; b <= left_rad; b += kStep_m / r) {
      const GridCell cell =
          LocalGrid::cell_of(to_outer(pose, Point2{r * std::cos(b), r * std::sin(b)}));
      if (grid.state(cell) == FloorState::free || grid.log_odds(cell) >= kEnough) continue;
      grid.add(cell, kGain, percept.stamp);
    }
  }
}

}  // namespace striate
