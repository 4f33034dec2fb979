#include "striate/memory/short_term/felt_things.hpp"

#include <algorithm>

namespace striate::memory {
namespace {

constexpr float kComesOrGoes = 0.3F;  // by hand, as where occupancy_updater clears fast

/// Calls `visit` with a felt patch and those about it. An echo is a point of a thing, and no thing
/// that stops a robot is narrower than three patches, 0.15 m (by hand).
template <class Visit>
void about(GridCell cell, const Visit& visit) {
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) visit(GridCell{x, y});
  }
}

/// Somebody who was seen to come is the eyes' to follow, and may go on at once.
bool something_moves_at(const LocalGrid& grid, GridCell cell) {
  bool moves = false;
  about(cell, [&](GridCell near) { moves = moves || grid.moving(near) > kComesOrGoes; });
  return moves;
}

void write(LocalGrid& grid, GridCell cell, float log_odds, TimePoint now) {
  about(cell, [&](GridCell near) { grid.add(near, log_odds - grid.log_odds(near), now); });
}

}  // namespace

void FeltThings::feel(Point2 place, TimePoint now) {
  last_ = now;
  const GridCell cell = LocalGrid::cell_of(place);
  for (std::size_t i = 0; i < count_; ++i) {
    if (LocalGrid::cell_of(things_[i].place) == cell) {
      things_[i].felt = now;
      return;
    }
  }
  if (count_ < kMost) {
    things_[count_++] = {place, now};
    return;
  }
  *std::min_element(things_.begin(), things_.end(),
                    [](const Thing& a, const Thing& b) { return a.felt < b.felt; }) = {place, now};
}

void FeltThings::keep_in(LocalGrid& grid, TimePoint now) {
  for (std::size_t i = 0; i < count_;) {
    const Thing& thing = things_[i];
    const GridCell cell = LocalGrid::cell_of(thing.place);
    const bool old = now - thing.felt > kBelieved;
    // From then on it is unknown: the eyes decide.
    if (old) write(grid, cell, 0.0F, now);
    if (old || something_moves_at(grid, cell)) {
      things_[i] = things_[--count_];
      continue;
    }
    write(grid, cell, LocalGrid::kMost, now);
    ++i;
  }
}

}  // namespace striate::memory
