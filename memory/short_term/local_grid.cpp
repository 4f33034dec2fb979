#include "striate/memory/short_term/local_grid.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::memory {
namespace {

std::int32_t milliseconds(TimePoint time) {
  return static_cast<std::int32_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count());
}

}  // namespace

LocalGrid::LocalGrid()
    : cells_(static_cast<std::size_t>(kSide) * kSide), scratch_(cells_.size(), 0.0F) {}

GridCell LocalGrid::cell_of(Point2 odometry) {
  return {cell_below(odometry.x_m / kCell_m), cell_below(odometry.y_m / kCell_m)};
}

Point2 LocalGrid::centre_of(GridCell cell) {
  return {(cell.x + 0.5) * kCell_m, (cell.y + 0.5) * kCell_m};
}

bool LocalGrid::holds(GridCell cell) const {
  return cell.x >= first_.x && cell.x < first_.x + kSide && cell.y >= first_.y &&
         cell.y < first_.y + kSide;
}

GridCell LocalGrid::first_around(Point2 odometry) {
  const GridCell middle = cell_of(odometry);
  return {middle.x - kSide / 2, middle.y - kSide / 2};
}

void LocalGrid::centre_on(Point2 odometry) {
  const GridCell wanted = first_around(odometry);
  if (std::abs(wanted.x - first_.x) >= kSide || std::abs(wanted.y - first_.y) >= kSide) {
    forget();
    first_ = wanted;
    return;
  }
  while (first_.x < wanted.x) forget_column(first_.x++);
  while (first_.x > wanted.x) forget_column(--first_.x);
  while (first_.y < wanted.y) forget_row(first_.y++);
  while (first_.y > wanted.y) forget_row(--first_.y);
}

// Storage wraps round: the column that leaves on one side is the one that enters on the other.
void LocalGrid::forget_column(int x) {
  for (int y = 0; y < kSide; ++y) cells_[index({x, y})] = {};
}

void LocalGrid::forget_row(int y) {
  for (int x = 0; x < kSide; ++x) cells_[index({x, y})] = {};
}

void LocalGrid::forget() {
  std::fill(cells_.begin(), cells_.end(), Stored{});
}

float LocalGrid::log_odds(GridCell cell) const {
  return holds(cell) ? cells_[index(cell)].log_odds : 0.0F;
}

float LocalGrid::moving(GridCell cell) const {
  return holds(cell) ? cells_[index(cell)].moving : 0.0F;
}

TimePoint LocalGrid::last_seen(GridCell cell) const {
  return TimePoint(std::chrono::milliseconds(holds(cell) ? cells_[index(cell)].seen_ms : 0));
}

CellState LocalGrid::state(GridCell cell) const {
  const float evidence = log_odds(cell);
  if (evidence > kOccupiedAbove) return CellState::occupied;
  return evidence < kFreeBelow ? CellState::free : CellState::unknown;
}

bool LocalGrid::stands(GridCell cell) const {
  const float evidence = log_odds(cell);
  if (evidence <= kOccupiedAbove) return false;
  if (evidence > kSurelyOccupied) return true;
  int occupied = -1;  // itself
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) occupied += log_odds({x, y}) > kOccupiedAbove;
  }
  return occupied >= 2;
}

void LocalGrid::add(GridCell cell, float log_odds, TimePoint seen) {
  if (!holds(cell)) return;
  Stored& stored = cells_[index(cell)];
  stored.log_odds = std::clamp(stored.log_odds + log_odds, kLeast, kMost);
  if (stored.log_odds < kFreeBelow) stored.height_m = stored.hangs_from_m = 0.0F;
  stored.seen_ms = milliseconds(seen);
}

void LocalGrid::set_moving(GridCell cell, float moving) {
  if (holds(cell)) cells_[index(cell)].moving = std::clamp(moving, 0.0F, 1.0F);
}

float LocalGrid::height_m(GridCell cell) const {
  return holds(cell) ? cells_[index(cell)].height_m : 0.0F;
}

void LocalGrid::raise_to(GridCell cell, float height_m) {
  if (!holds(cell)) return;
  Stored& stored = cells_[index(cell)];
  stored.height_m = std::max(stored.height_m, height_m);
}

float LocalGrid::hangs_from_m(GridCell cell) const {
  return holds(cell) ? cells_[index(cell)].hangs_from_m : 0.0F;
}

void LocalGrid::hang_from(GridCell cell, float height_m) {
  if (holds(cell)) cells_[index(cell)].hangs_from_m = height_m;
}

void LocalGrid::clear(GridCell cell, TimePoint seen) {
  if (holds(cell)) cells_[index(cell)] = {kLeast, 0.0F, 0.0F, 0.0F, milliseconds(seen)};
}

void LocalGrid::fade(const Fade& factor) {
  for (Stored& cell : cells_) {
    const float still = cell.log_odds > 0.0F ? factor.occupied : factor.free;
    const float apart = cell.log_odds > 0.0F ? factor.moving : factor.free;
    cell.log_odds *= still + cell.moving * (apart - still);
    cell.moving *= cell.log_odds > 0.0F ? 1.0F : factor.moving;
  }
}

void LocalGrid::blur_older_than(TimePoint before, float share) {
  const std::int32_t before_ms = milliseconds(before);
  for (std::size_t i = 0; i < cells_.size(); ++i) scratch_[i] = cells_[i].log_odds;
  for (int y = first_.y + 1; y < first_.y + kSide - 1; ++y) {
    for (int x = first_.x + 1; x < first_.x + kSide - 1; ++x) {
      Stored& cell = cells_[index({x, y})];
      if (cell.seen_ms >= before_ms) continue;
      const float round = scratch_[index({x + 1, y})] + scratch_[index({x - 1, y})] +
                          scratch_[index({x, y + 1})] + scratch_[index({x, y - 1})];
      cell.log_odds += share * (0.25F * round - cell.log_odds);
    }
  }
}

}  // namespace striate::memory
