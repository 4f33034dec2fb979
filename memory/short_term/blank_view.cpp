#include "striate/memory/short_term/blank_view.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace striate::memory {
namespace {

// "By hand": README.md, "Where the numbers come from"; the tests are BlankView.*, the world is
// hard_blank_wall.yaml. The shares and the trust are set for what noise matches in the dark.

constexpr double kLeastKnown = 0.12;  // by hand: share of columns that know something
constexpr double kLeastFloor = 0.05;  // by hand: share of columns that see floor
constexpr double kLeastTrust = 0.16;  // by hand: confidence in things, mean over columns
constexpr double kNoisy = 1.0;        // by hand, grey levels; from here on noise alone matches
// While the robot drives where it looks, the pan is 0.16 rad at most (path_follower.cpp).
constexpr double kAheadOfView_rad = 0.25;
constexpr int kPatience = 6;  // by hand, images: some may be blurred
constexpr int kSurely = 2;    // by hand: so many does one count in which hardly anything is known
constexpr double kMostPan_rad = 0.8;  // by hand: farther round lies the wall that is driven along
constexpr double kFrom_m = 0.40;      // clear of the outline's circle about the axle, 0.37 m
constexpr double kTo_m = 1.00;        // by hand: farther off the skirting would be in view
// By hand, log-odds: two images reach what blocks (LocalGrid::kOccupiedAbove), four are enough.
constexpr float kGain = 0.6F;
constexpr float kEnough = 2.0F;
constexpr double kStep_m = LocalGrid::kCell_m;

/// What the columns of an image know, as shares of all of them.
struct Known {
  double anything = 0.0;
  double floor = 0.0;
  double trust = 0.0;  ///< in things: each counts by its confidence
};

Known known_of(const std::vector<perception::Column>& columns) {
  Known known;
  for (const perception::Column& column : columns) {
    const bool sees_floor = column.free_to_m > column.free_from_m;
    const bool sees_thing = std::isfinite(column.obstacle_m);
    if (sees_floor || sees_thing) ++known.anything;
    if (sees_floor) ++known.floor;
    if (sees_thing) known.trust += column.obstacle_confidence;
  }
  const auto all = static_cast<double>(columns.size());
  return {known.anything / all, known.floor / all, known.trust / all};
}

/// How many images this one counts for as a blank surface; 0: it is none. In the dark noise
/// matches here and there at any distance, with little confidence. That it does is weaker evidence
/// than a view without any match: it needs more images, and counts only ahead, where a robot
/// that drives on would touch. Aside it would shut narrow places whose walls are as dark.
int blankness(const perception::Percept& percept, double pan_rad) {
  const Known known = known_of(percept.columns);
  if (known.anything < kLeastKnown) return kSurely;
  const bool noise_alone =
      percept.noise_level > kNoisy && known.floor < kLeastFloor && known.trust < kLeastTrust;
  return noise_alone && std::abs(pan_rad) < kAheadOfView_rad ? 1 : 0;
}

}  // namespace

void BlankView::see(const perception::Percept& percept, const Pose2& pose, LocalGrid& grid) {
  const auto& columns = percept.columns;
  if (columns.empty()) return;
  const double left_rad = columns.front().bearing_rad;
  const double right_rad = columns.back().bearing_rad;
  const double pan_rad = 0.5 * (left_rad + right_rad);
  const int blank = blankness(percept, pan_rad);
  blankness_ = blank > 0 ? std::min(kPatience, blankness_ + blank) : 0;
  if (blankness_ < kPatience || std::abs(pan_rad) > kMostPan_rad) return;
  for (double r = kFrom_m; r <= kTo_m; r += kStep_m) {
    for (double b = right_rad; b <= left_rad; b += kStep_m / r) {
      const GridCell cell =
          LocalGrid::cell_of(transform(pose, Point2{r * std::cos(b), r * std::sin(b)}));
      if (grid.state(cell) == CellState::free || grid.log_odds(cell) >= kEnough) continue;
      grid.add(cell, kGain, percept.stamp);
    }
  }
}

}  // namespace striate::memory
