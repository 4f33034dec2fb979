#include "striate/platform/simulator/doorways.hpp"

#include <algorithm>

#include "striate/platform/simulator/corridor_width.hpp"
#include "striate/platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {

std::vector<Doorway> doorways(const World& world, const FloorPlan& plan, const ClearanceMap& map) {
  // Before and behind a door leaf: a person's radius and 0.2 m of room (ours)
  constexpr double kStep_m = 0.45;
  std::vector<Doorway> result;
  for (const Door& door : world.doors) {
    const double sign = door.side == Side::left ? 1.0 : -1.0;
    const double wall = half_width_m(world, door.at_m);
    const auto at = [&](double left_m) {
      const Pose2 pose = plan.at(door.at_m, sign * left_m);
      return Point2{pose.x_m, pose.y_m};
    };
    const Doorway way{at(wall - kStep_m), at(wall), at(wall + kStep_m)};
    if (map.at(way.inside) >= kPersonRadius_m) result.push_back(way);
  }
  return result;
}

std::optional<WayOut> way_out(Point2 from, const std::vector<Doorway>& doors,
                              const ClearanceMap& map, double within_m) {
  std::vector<const Doorway*> near;
  for (const Doorway& door : doors) {
    if (distance_m(from, door.inside) <= within_m) near.push_back(&door);
  }
  std::sort(near.begin(), near.end(), [&](const Doorway* a, const Doorway* b) {
    return distance_m(from, a->inside) < distance_m(from, b->inside);
  });
  for (const Doorway* door : near) {
    auto way = map.way(from, door->inside, kPersonRadius_m + 0.02);
    if (!way) continue;
    way->push_back(door->outside);
    return WayOut{std::move(*way), door->sill};
  }
  return std::nullopt;
}

}  // namespace striate::simulator
