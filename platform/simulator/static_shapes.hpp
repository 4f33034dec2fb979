#pragma once

#include <string>
#include <vector>

#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/shapes.hpp"

namespace striate::simulator {

/// Something that stands in the corridor and never moves, in the plan.
struct StaticShape {
  std::string name;  ///< "wall", "pillar_1", or the obstacle's name
  ConvexShape shape;
  Point2 middle;
  double bounding_m = 0.0;  ///< no part is farther from `middle`
};

/// What an obstacle covers of the floor, in the plan.
[[nodiscard]] std::vector<ConvexShape> obstacle_outline(const WorldObstacle& obstacle,
                                                        const FloorPlan& plan);

/// Pillars and obstacles; stairs, too, which nobody walks into.
[[nodiscard]] std::vector<StaticShape> standing_shapes(const World& world, const FloorPlan& plan);

/// Those of them that can be touched: not stairs, which are a hole.
[[nodiscard]] std::vector<StaticShape> solid_shapes(const World& world, const FloorPlan& plan);

/// The holes in the floor: stairs that go down.
[[nodiscard]] std::vector<StaticShape> drops(const World& world, const FloorPlan& plan);

/// The world with those of its obstacles for which `kept(obstacle)` is true, and its pillars.
template <class Kept>
[[nodiscard]] World with_obstacles(World world, Kept kept) {
  std::erase_if(world.obstacles, [&](const WorldObstacle& thing) { return !kept(thing); });
  return world;
}

/// The walls, each as a line without thickness.
[[nodiscard]] std::vector<StaticShape> wall_shapes(const FloorPlan& plan);

/// The way along corridor points, in the plan: bends of the corridor become corners of the way.
[[nodiscard]] std::vector<Point2> plan_path(const World& world, const FloorPlan& plan,
                                            const std::vector<Point2>& corridor_points);

}  // namespace striate::simulator
