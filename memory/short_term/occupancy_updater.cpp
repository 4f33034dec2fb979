#include "striate/memory/short_term/occupancy_updater.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::memory {
namespace {

constexpr double kRayStep_m = LocalGrid::kCell_m;
// "By hand": README.md, "Where the numbers come from"; the tests are Evidence.*.

constexpr double kBlobDepth_m = 0.4;  // by hand: a column nearer to a blob than this is part of it
constexpr double kPastFrom_m = 0.25;  // just beyond the front end, 0.21 m before the axle
// By hand: by so much a thing must be higher than the line of sight for that to pass through it.
constexpr float kSurelyHigher_m = 0.25F;
// Something has come where floor was free so recently and so surely: as sure as a thing must be to
// block (LocalGrid::kOccupiedAbove), by hand the rest. Farther off than the last, where a range
// errs by 0.18 m, noise looks like motion.
constexpr double kStartled_s = 3.0;
constexpr float kSurelyFree = -1.2F;  // log-odds
constexpr double kMotionSeen_m = 3.5;
// What is lower may have been floor to the eyes from farther off: less than the height of one px of
// disparity 6 m away (perception/README.md). Nobody who walks is so low.
constexpr float kLow_m = 0.30F;
// By hand, 0 still .. 1 moving: what stays calms in 17 looks to kSettled, and slowly from there on.
constexpr float kSettled = 0.35F;
constexpr float kCalming = 0.94F;    // factor of each look
constexpr float kCalmingOn = 0.99F;  // factor of each look, below kSettled
// By hand: below the first a thing is still; above the second free floor counts kEager times.
constexpr float kStill = 0.2F;
constexpr float kStirs = 0.3F;
constexpr double kEager = 2.0;
constexpr double kBeside_m = 0.15;           // by hand, three patches: so far an edge wanders
constexpr double kLeastRangeError_m = 0.02;  // by hand: less than half a patch says nothing
// By hand: columns agree within this and two sigma of their range; one that agrees is worth so
// much, two are worth 1, none OccupancySettings::lone_column_weight.
constexpr double kAgree_m = 0.08;
constexpr double kAgreeSigmas = 2.0;
constexpr double kOneAgrees = 0.6;
// By hand: evidence is spread along the ray to 1.2 sigma (77 % of it), less of a weight than the
// last is left out; beyond a sigma of 0.1 m, two patches, it is thinned.
constexpr double kSpreadSigmas = 1.2;
constexpr double kThinFrom_m = 0.1;
constexpr int kMostSpread = LocalGrid::kSide;  // each way, in steps of a cell: all of the map
constexpr double kLeastWeight = 0.02;
// By hand: the view is 0.79 times as wide as it is far, so that of a table of 1.4 m both ends are
// seen from here on; nearer, it takes seven seconds of free floor to clear what was no table.
constexpr double kEndsInView_m = 1.8;
constexpr double kHardly = 0.1;       // share of a look at floor
constexpr double kHidesBeside = 1.5;  // by hand: a cell two thirds full shows no floor beside it
constexpr double kMostlyFull = 0.3;   // by hand: share of a look from which a thing has come
constexpr double kNearest_m = 0.1;    // by hand: nearer than that no column reaches

std::size_t slot(GridCell cell) {
  return static_cast<std::size_t>(cell.y & (LocalGrid::kSide - 1)) * LocalGrid::kSide +
         static_cast<std::size_t>(cell.x & (LocalGrid::kSide - 1));
}

/// How much the floor seen free tells of what hangs over it. Near by, the edge of a table is wider
/// than the view, and says nothing without its ends; the floor beneath it is seen all the same.
double told_of_what_hangs(float hangs_from_m, double distance_m) {
  return hangs_from_m > 0.0F && distance_m < kEndsInView_m ? kHardly : 1.0;
}

/// A thing that stands is measured anew in every image, so its edge wanders over floor that was
/// seen free; that is no motion.
bool beside_something_still(GridCell cell, const LocalGrid& grid) {
  constexpr int kReach = static_cast<int>(kBeside_m / LocalGrid::kCell_m);
  for (int y = cell.y - kReach; y <= cell.y + kReach; ++y) {
    for (int x = cell.x - kReach; x <= cell.x + kReach; ++x) {
      if (grid.state({x, y}) == CellState::occupied && grid.moving({x, y}) < kStill) return true;
    }
  }
  return false;
}

}  // namespace

OccupancyUpdater::OccupancyUpdater(const OccupancySettings& settings, double camera_height_m)
    : settings_(settings),
      camera_height_m_(camera_height_m),
      masses_(static_cast<std::size_t>(LocalGrid::kSide) * LocalGrid::kSide) {
  touched_.reserve(masses_.size());
  heights_m_.reserve(4096);
}

double OccupancyUpdater::range_error_m(double distance_m) const {
  return std::max(kLeastRangeError_m,
                  settings_.disparity_error_px * distance_m * distance_m / disparity_metre_px_);
}

void OccupancyUpdater::write(const perception::Percept& percept, const Pose2& pose,
                             LocalGrid& grid) {
  const std::vector<perception::Column>& columns = percept.columns;
  if (columns.size() < 2) return;
  disparity_metre_px_ = percept.disparity.focal_px * percept.disparity.baseline_m;
  measure_heights(percept);
  const double span = std::abs(wrap_angle(columns.back().bearing_rad - columns[0].bearing_rad));
  const ViewOfImage look{pose, percept.stamp, span / static_cast<double>(columns.size() - 1),
                         percept.top_slope};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    gather_free(columns[i], look);
    gather_past(columns[i], look);
    gather_occupied(columns[i], support_of(columns, i), heights_m_[i], look);
  }
  for (const GridCell cell : touched_) {
    Mass& mass = masses_[slot(cell)];
    settle(cell, mass, look, grid);
    mass = {};
  }
  touched_.clear();
}

// A wrong match seldom has neighbours that are wrong by the same distance.
double OccupancyUpdater::support_of(const std::vector<perception::Column>& columns,
                                    std::size_t i) const {
  const perception::Column& column = columns[i];
  if (!(column.obstacle_m < settings_.far_m)) return 0.0;
  const double tolerance_m = kAgree_m + kAgreeSigmas * range_error_m(column.obstacle_m);
  int agreeing = 0;
  const std::size_t last = std::min(columns.size() - 1, i + 2);
  for (std::size_t j = i >= 2 ? i - 2 : 0; j <= last; ++j) {
    if (j != i && std::abs(columns[j].obstacle_m - column.obstacle_m) < tolerance_m) ++agreeing;
  }
  if (agreeing >= 2) return 1.0;
  return agreeing == 1 ? kOneAgrees : settings_.lone_column_weight;
}

OccupancyUpdater::Mass& OccupancyUpdater::touch(GridCell cell) {
  Mass& mass = masses_[slot(cell)];
  if (!mass.touched) {
    touched_.push_back(cell);
    mass.touched = true;
  }
  return mass;
}

// Each column's obstacle belongs to a blob at about its distance; the blob knows how high it is.
void OccupancyUpdater::measure_heights(const perception::Percept& percept) {
  heights_m_.assign(percept.columns.size(), 0.0F);
  const int columns = static_cast<int>(percept.columns.size());
  for (const perception::Obstacle& blob : percept.obstacles) {
    for (int u = std::max(0, blob.from_u_px); u <= std::min(columns - 1, blob.to_u_px); ++u) {
      const auto at = static_cast<std::size_t>(u);
      const double apart_m = std::abs(percept.columns[at].obstacle_m - blob.distance_m);
      if (apart_m < kBlobDepth_m) heights_m_[at] = static_cast<float>(blob.height_m);
    }
  }
}

// The line of sight to where the floor comes into view passes over what is nearer: anything higher
// than that line would have been met. A person who stood close and left leaves no floor to see
// where they stood, but their place is seen through.
void OccupancyUpdater::gather_past(const perception::Column& column, const ViewOfImage& look) {
  if (!(column.free_to_m > column.free_from_m)) return;
  const double angle = look.pose.heading_rad + column.bearing_rad;
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  const auto weight = static_cast<float>(column.free_confidence);
  for (double r = kPastFrom_m; r < std::min(column.free_from_m, settings_.far_m); r += kRayStep_m) {
    const GridCell cell = LocalGrid::cell_of({look.pose.x_m + r * dx, look.pose.y_m + r * dy});
    Mass& mass = touch(cell);
    mass.past += weight;
    mass.past_above_m = static_cast<float>(camera_height_m_ * (1.0 - r / column.free_from_m));
  }
}

void OccupancyUpdater::gather_free(const perception::Column& column, const ViewOfImage& look) {
  const double to_m = std::min({column.free_to_m, settings_.far_m, column.obstacle_m});
  if (column.free_confidence <= 0.0 || !(to_m > column.free_from_m)) return;
  const double angle = look.pose.heading_rad + column.bearing_rad;
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  const auto weight = static_cast<float>(column.free_confidence);
  for (double r = std::max(0.0, column.free_from_m); r < to_m; r += kRayStep_m) {
    touch(LocalGrid::cell_of({look.pose.x_m + r * dx, look.pose.y_m + r * dy})).free += weight;
  }
}

// The error of a range grows with its square (Z = f b / d), so the evidence is
// spread along the ray as far as the thing may really stand, and thinned by that spread.
void OccupancyUpdater::gather_occupied(const perception::Column& column, double support,
                                       double height_m, const ViewOfImage& look) {
  if (support <= 0.0 || column.obstacle_confidence <= 0.0) return;
  const double sigma_m = range_error_m(column.obstacle_m);
  const double peak =
      column.obstacle_confidence * support * std::min(1.0, std::sqrt(kThinFrom_m / sigma_m));
  const double angle = look.pose.heading_rad + column.bearing_rad;
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  const int steps = ceil_within(kSpreadSigmas * sigma_m / kRayStep_m, 0, kMostSpread);
  for (int k = -steps; k <= steps; ++k) {
    const double offset_m = k * kRayStep_m;
    const double weight = peak * std::exp(-0.5 * offset_m * offset_m / (sigma_m * sigma_m));
    const double r = column.obstacle_m + offset_m;
    if (r <= 0.0 || weight < kLeastWeight) continue;
    Mass& mass = touch(LocalGrid::cell_of({look.pose.x_m + r * dx, look.pose.y_m + r * dy}));
    const auto hangs_from_m = static_cast<float>(column.hangs_from_m);
    mass.hangs_from_m =
        mass.occupied > 0.0F ? std::min(mass.hangs_from_m, hangs_from_m) : hangs_from_m;
    mass.occupied += static_cast<float>(weight);
    mass.height_m = std::max(mass.height_m, static_cast<float>(height_m));
  }
}

void OccupancyUpdater::settle(GridCell cell, const Mass& mass, const ViewOfImage& look,
                              LocalGrid& grid) const {
  const Point2 centre = LocalGrid::centre_of(cell);
  const double distance_m = std::hypot(centre.x_m - look.pose.x_m, centre.y_m - look.pose.y_m);
  // How many columns a cell at this distance can meet; a full look is all of them.
  const double meeting =
      std::max(1.0, kRayStep_m / (std::max(distance_m, kNearest_m) * look.column_rad));
  const double occupied = std::min(1.0, mass.occupied / meeting);
  // A thin thing fills a part of its cell; the rest of the columns pass beside it.
  const double beside = std::max(0.0, 1.0 - kHidesBeside * occupied);
  const double tells = floor_says_nothing(cell, distance_m, look, grid)
                           ? 0.0
                           : told_of_what_hangs(grid.hangs_from_m(cell), distance_m);
  const double free = tells * beside * std::min(1.0, mass.free / meeting);
  const double boost = distance_m < settings_.near_m ? settings_.near_boost : 1.0;
  const float before = grid.log_odds(cell);
  if (mass.occupied == 0.0F && mass.free == 0.0F) {
    settle_past(cell, mass, std::min(1.0, mass.past / meeting), look, grid);
    return;
  }
  const double eager =
      grid.moving(cell) > kStirs ? kEager : 1.0;  // where things move free clears fast
  const double change =
      boost * settings_.occupied_gain * occupied - eager * settings_.free_gain * free;
  if (occupied > kMostlyFull && change > 0.0) {
    const bool startled = before < kSurelyFree && distance_m < kMotionSeen_m &&
                          to_seconds(look.stamp - grid.last_seen(cell)) < kStartled_s &&
                          !beside_something_still(cell, grid);
    const bool only_seen_now = was_taken_for_floor(cell, mass, grid);
    const float moved = grid.moving(cell);
    // What has moved may move on: it calms quickly, but not wholly.
    const float calm = (moved > kSettled ? kCalming : kCalmingOn) * moved;
    grid.set_moving(cell, startled && !only_seen_now ? 1.0F : calm);
    // Something is where floor was seen: the old free evidence is void.
    if (startled || only_seen_now) grid.add(cell, -before, look.stamp);
  }
  grid.add(cell, static_cast<float>(change), look.stamp);
  if (change <= 0.0) return;
  grid.raise_to(cell, mass.height_m);
  grid.hang_from(cell, mass.hangs_from_m);
}

/// The floor beneath what hangs is seen wherever the view is too low for the thing itself.
bool OccupancyUpdater::floor_says_nothing(GridCell cell, double distance_m, const ViewOfImage& look,
                                          const LocalGrid& grid) const {
  const float hangs_from_m = grid.hangs_from_m(cell);
  return hangs_from_m > 0.0F && hangs_from_m > camera_height_m_ + distance_m * look.top_slope;
}

/// What is low looks like floor from farther off: that it is seen now is no motion.
bool OccupancyUpdater::was_taken_for_floor(GridCell cell, const Mass& mass, const LocalGrid& grid) {
  return mass.height_m > 0.0F && mass.height_m < kLow_m && grid.log_odds(cell) < 0.0F &&
         !beside_something_still(cell, grid);
}

void OccupancyUpdater::settle_past(GridCell cell, const Mass& mass, double share,
                                   const ViewOfImage& look, LocalGrid& grid) const {
  const float before = grid.log_odds(cell);
  if (before <= 0.0F || grid.height_m(cell) < mass.past_above_m + kSurelyHigher_m) return;
  if (grid.hangs_from_m(cell) > 0.0F) return;  // the line of sight may have passed beneath it
  // Down to unknown at most: that nothing high is there does not make the floor free.
  const auto change = static_cast<float>(settings_.free_gain * share);
  grid.add(cell, -std::min(before, change), look.stamp);
}

}  // namespace striate::memory
