#include "striate/platform/simulator/start_place.hpp"

#include <fmt/format.h>

#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/late_obstacles.hpp"
#include "striate/platform/simulator/static_shapes.hpp"
#include "striate/platform/simulator/world_entry.hpp"

namespace striate::simulator {

std::string overlapped_by(const World& world, const FloorPlan& plan, const ConvexShape& body) {
  for (const StaticShape& wall : wall_shapes(plan)) {
    if (distance_m(body, wall.shape) <= 0.0) return "a wall";
  }
  for (const StaticShape& thing : standing_shapes(world, plan)) {
    if (distance_m(body, thing.shape) <= 0.0) return thing.name;
  }
  for (const Stander& stander : world.standers) {
    const Pose2 at = plan.at(stander.at.x_m, stander.at.y_m);
    if (distance_m(body, disc({at.x_m, at.y_m}, kPersonRadius_m)) <= 0.0) return "a person";
  }
  return "";
}

void check_place(const World& world, const std::string& what, const Pose2& along,
                 const ConvexShape& body) {
  const FloorPlan plan = build_floor_plan(world);
  Pose2 at = plan.at(along.x_m, along.y_m);
  at.heading_rad += along.heading_rad;
  const bool on_the_way = along.x_m >= 0.0 && along.x_m <= world.length_m;
  const std::string place = fmt::format("{}, {}", metres(along.x_m), metres(along.y_m));
  if (!on_the_way || !inside_polygon({at.x_m, at.y_m}, plan.outline)) {
    throw UserError(
        fmt::format("{}: {} lies outside {}\n    give metres along it, from 0 to {}, and to the "
                    "left of its middle",
                    what, place, world.name, metres(world.length_m)));
  }
  const World at_first = world_without(world, late_obstacles_of(world));
  const std::string hit = overlapped_by(at_first, plan, moved(body, at));
  if (hit.empty()) return;
  throw UserError(
      fmt::format("{}: {} overlaps {}\n    give a place with more room", what, place, hit));
}

}  // namespace striate::simulator
