#include "striate/viewer/channels/map_facts.hpp"

#include <cmath>

#include "striate/memory/long_term/records.hpp"

namespace striate::viewer {
namespace {

/// Cells of the map that are shown, each way: 25.6 m, twice the window of short-term memory
constexpr int kGlobalSide = 256;

}  // namespace

void take_local(const memory::LocalGrid& grid, FloorGrid& floor) {
  constexpr int kSide = memory::LocalGrid::kSide;
  const memory::GridCell first = grid.first();
  floor.cell_m = memory::LocalGrid::kCell_m;
  floor.corner = {first.x * floor.cell_m, first.y * floor.cell_m};
  floor.columns = floor.rows = kSide;
  floor.percent.resize(static_cast<std::size_t>(kSide) * kSide);
  std::size_t k = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x, ++k) {
      const memory::CellState state = grid.state({first.x + x, first.y + y});
      floor.percent[k] = state == memory::CellState::unknown ? std::int8_t{-1}
                         : state == memory::CellState::free  ? std::int8_t{0}
                                                             : std::int8_t{100};
    }
  }
}

void take_global(const memory::Localisation& place, FloorGrid& floor) {
  const double cell_m = memory::kObstacleCell_m;
  const Pose2 pose = place.estimate().pose();
  const auto first = [cell_m](double at_m) {
    return (std::floor(at_m / cell_m) - 0.5 * kGlobalSide) * cell_m;
  };
  floor.cell_m = cell_m;
  floor.corner = {first(pose.x_m), first(pose.y_m)};
  floor.columns = floor.rows = kGlobalSide;
  floor.percent.resize(static_cast<std::size_t>(kGlobalSide) * kGlobalSide);
  std::size_t k = 0;
  for (int y = 0; y < kGlobalSide; ++y) {
    for (int x = 0; x < kGlobalSide; ++x, ++k) {
      const float log_odds = place.obstacles().log_odds(
          {floor.corner.x_m + (x + 0.5) * cell_m, floor.corner.y_m + (y + 0.5) * cell_m});
      floor.percent[k] =
          log_odds == 0.0F
              ? std::int8_t{-1}
              : static_cast<std::int8_t>(std::lround(100.0F / (1.0F + std::exp(-log_odds))));
    }
  }
}

void take_routes(const memory::Localisation& place, SlowFacts& slow) {
  slow.routes.clear();
  if (!place.located()) return;
  for (const memory::Route& route : place.routes().all()) {
    const auto from = place.estimate().place(route.from);
    const auto to = place.estimate().place(route.to);
    if (from && to) slow.routes.push_back({{from->x_m, from->y_m}, {to->x_m, to->y_m}});
  }
}

void take_map(const memory::Localisation& place, CycleFacts& facts) {
  facts.on_map.reset();
  if (!place.located()) return;
  facts.on_map = {place.estimate().pose(), place.estimate().pose_covariance(),
                  place.estimate().from_odometry()};
}

}  // namespace striate::viewer
