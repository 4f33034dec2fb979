#include <algorithm>

#include "striate/perception/low_things/low_things.hpp"
#include "striate/perception/obstacles/floor_state.hpp"

namespace striate::perception {
namespace {

/// Nearer by less is the same thing, seen twice: its foot and its trunk
constexpr double kSameLowThing_m = 0.10;
/// Free floor ends before it, as before every obstacle (obstacles.cpp)
constexpr double kLowClearance_m = 0.05;

void block(const Column& low, Column& column) {
  column.bearing_rad = low.bearing_rad;
  column.obstacle_m = low.obstacle_m;
  column.obstacle_confidence = low.obstacle_confidence;
  hide_behind_obstacle(column, low.hidden_to_m);
  column.free_to_m = std::min(column.free_to_m, low.obstacle_m - kLowClearance_m);
  if (column.free_to_m <= column.free_from_m) {
    column.free_from_m = column.free_to_m = column.free_confidence = 0.0;
  }
}

}  // namespace

void add_low_things(const ObstacleView& low, ObstacleView& view) {
  if (low.columns.empty() || view.columns.empty()) return;
  const std::size_t finer = low.columns.size() / view.columns.size();
  if (finer == 0) return;
  for (std::size_t u = 0; u < view.columns.size(); ++u) {
    const auto from = low.columns.begin() + static_cast<std::ptrdiff_t>(u * finer);
    const auto nearest = std::min_element(
        from, from + static_cast<std::ptrdiff_t>(finer),
        [](const Column& a, const Column& b) { return a.obstacle_m < b.obstacle_m; });
    if (nearest->obstacle_m < view.columns[u].obstacle_m - kSameLowThing_m) {
      block(*nearest, view.columns[u]);
    }
  }
  const int scale = static_cast<int>(finer);
  for (Obstacle thing : low.obstacles) {
    thing.from_u_px /= scale;
    thing.to_u_px /= scale;
    view.obstacles.push_back(thing);
  }
  std::stable_sort(
      view.obstacles.begin(), view.obstacles.end(),
      [](const Obstacle& a, const Obstacle& b) { return a.distance_m < b.distance_m; });
}

}  // namespace striate::perception
