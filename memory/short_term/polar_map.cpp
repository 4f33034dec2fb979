#include "striate/memory/short_term/polar_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::memory {
namespace {

constexpr float kFreeShare = 0.6F;  // by hand: of a polar cell's patches that must be seen free

struct Tally {
  int patches = 0;
  int free = 0;
  float free_sum = 0.0F;
  float strongest = -10.0F;
  float moving = 0.0F;
  TimePoint seen{};
};

PolarMap::Cell judge(const Tally& tally, TimePoint now) {
  PolarMap::Cell cell;
  cell.age_s = tally.seen == TimePoint{} ? std::numeric_limits<float>::infinity()
                                         : static_cast<float>(to_seconds(now - tally.seen));
  if (tally.patches == 0) return cell;
  if (tally.strongest > LocalGrid::kOccupiedAbove) {
    cell.state = CellState::occupied;
    cell.log_odds = tally.strongest;
    cell.moving = tally.moving;
  } else if (static_cast<float>(tally.free) >= kFreeShare * static_cast<float>(tally.patches)) {
    cell.state = CellState::free;
    cell.log_odds = tally.free_sum / static_cast<float>(tally.free);
  } else {
    cell.log_odds = std::max(0.0F, tally.strongest);
  }
  return cell;
}

void count(const LocalGrid& grid, GridCell patch, Tally& tally) {
  const float evidence = grid.log_odds(patch);
  ++tally.patches;
  if (evidence < LocalGrid::kFreeBelow) {
    ++tally.free;
    tally.free_sum += evidence;
  }
  if (evidence > tally.strongest) {
    tally.strongest = evidence;
    tally.moving = grid.moving(patch);
  }
  tally.seen = std::max(tally.seen, grid.last_seen(patch));
}

}  // namespace

int PolarMap::sector_of(double bearing_rad) {
  const double turns = bearing_rad / (2.0 * std::numbers::pi);
  const double part = turns - std::floor(turns);
  return static_cast<int>(std::lround(part * kSectors)) % kSectors;
}

double PolarMap::sector_bearing_rad(int sector) {
  return wrap_angle(sector * kSector_rad);
}

double PolarMap::ring_outer_m(int ring) {
  return kInner_m * std::pow(kOuter_m / kInner_m, ring / static_cast<double>(kRings - 1));
}

int PolarMap::ring_of(double distance_m) {
  if (distance_m <= kInner_m) return 0;
  const double ring = std::log(distance_m / kInner_m) / std::log(kOuter_m / kInner_m);
  return std::min(kRings, static_cast<int>(std::ceil(ring * (kRings - 1) - 1e-9)));
}

PolarMap read_polar_map(const LocalGrid& grid, const Pose2& robot, TimePoint now) {
  std::array<Tally, static_cast<std::size_t>(PolarMap::kSectors) * PolarMap::kRings> tallies{};
  const GridCell first = grid.first();
  for (int y = first.y; y < first.y + LocalGrid::kSide; ++y) {
    for (int x = first.x; x < first.x + LocalGrid::kSide; ++x) {
      const Point2 place = inverse_transform(robot, LocalGrid::centre_of({x, y}));
      const double distance_m = std::hypot(place.x_m, place.y_m);
      if (distance_m >= PolarMap::kOuter_m) continue;
      const int sector = PolarMap::sector_of(std::atan2(place.y_m, place.x_m));
      const int ring = PolarMap::ring_of(distance_m);
      count(grid, {x, y}, tallies[static_cast<std::size_t>(sector * PolarMap::kRings + ring)]);
    }
  }
  PolarMap map;
  for (std::size_t i = 0; i < tallies.size(); ++i) map.cells[i] = judge(tallies[i], now);
  return map;
}

}  // namespace striate::memory
