#include "striate/perception/obstacles/floor_state.hpp"

#include <algorithm>
#include <cmath>

namespace striate::perception {
namespace {

constexpr double kOccupied_m = 0.1;  // depth assumed of an obstacle whose back is not seen (ours)

}  // namespace

FloorState floor_state(const Column& column, double range_m) {
  const double front_m = column.obstacle_m;
  if (range_m >= front_m && range_m <= front_m + kOccupied_m) return FloorState::occupied;
  if (range_m >= column.hidden_from_m && range_m < column.hidden_to_m) return FloorState::hidden;
  if (range_m >= column.free_from_m && range_m <= column.free_to_m &&
      column.free_to_m > column.free_from_m) {
    return FloorState::free;
  }
  return FloorState::unknown;
}

void hide_behind_obstacle(Column& column, double to_m) {
  const bool stands = std::isfinite(column.obstacle_m);
  column.hidden_from_m = stands ? column.obstacle_m : kNothing_m;
  column.hidden_to_m = stands ? std::max(to_m, column.obstacle_m) : kNothing_m;
}

}  // namespace striate::perception
