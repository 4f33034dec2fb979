#include "striate/platform/simulator/static_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "striate/platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {
namespace {

StaticShape named(std::string name, ConvexShape shape) {
  Point2 middle;
  for (const Point2& corner : shape.corners) {
    middle.x_m += corner.x_m / static_cast<double>(shape.corners.size());
    middle.y_m += corner.y_m / static_cast<double>(shape.corners.size());
  }
  const double bounding = bounding_radius_m(shape, middle);
  return {std::move(name), std::move(shape), middle, bounding};
}

}  // namespace

std::vector<ConvexShape> obstacle_outline(const WorldObstacle& obstacle, const FloorPlan& plan) {
  Pose2 pose = plan.at(obstacle.at.x_m, obstacle.at.y_m);
  pose.heading_rad += obstacle.turn_rad;
  std::vector<ConvexShape> shapes;
  for (const Footprint& polygon : footprint(obstacle)) {
    shapes.push_back(moved({polygon, 0.0}, pose));
  }
  return shapes;
}

std::vector<StaticShape> standing_shapes(const World& world, const FloorPlan& plan) {
  std::vector<StaticShape> shapes;
  int number = 0;
  for (const Pillar& pillar : world.pillars) {
    const Pose2 at = plan.at(pillar.at.x_m, pillar.at.y_m);
    shapes.push_back(
        named(fmt::format("pillar_{}", ++number), disc({at.x_m, at.y_m}, pillar.diameter_m / 2)));
  }
  for (const WorldObstacle& obstacle : world.obstacles) {
    for (ConvexShape& shape : obstacle_outline(obstacle, plan)) {
      shapes.push_back(named(obstacle.name, std::move(shape)));
    }
  }
  return shapes;
}

std::vector<StaticShape> solid_shapes(const World& world, const FloorPlan& plan) {
  const World solid = with_obstacles(
      world, [](const WorldObstacle& thing) { return thing.kind != ObstacleKind::stairs; });
  return standing_shapes(solid, plan);
}

std::vector<StaticShape> drops(const World& world, const FloorPlan& plan) {
  World holes = with_obstacles(
      world, [](const WorldObstacle& thing) { return thing.kind == ObstacleKind::stairs; });
  holes.pillars.clear();
  return standing_shapes(holes, plan);
}

std::vector<StaticShape> wall_shapes(const FloorPlan& plan) {
  std::vector<StaticShape> shapes;
  for (const WallSegment& wall : plan.walls) {
    shapes.push_back(named("wall", {{wall.from, wall.to}, 0.0}));
  }
  return shapes;
}

std::vector<Point2> plan_path(const World& world, const FloorPlan& plan,
                              const std::vector<Point2>& corridor_points) {
  std::vector<Point2> path;
  const auto push = [&](const Pose2& pose) { path.push_back({pose.x_m, pose.y_m}); };
  for (std::size_t i = 0; i < corridor_points.size(); ++i) {
    const Point2& to = corridor_points[i];
    if (i > 0) {
      const Point2& from = corridor_points[i - 1];
      std::vector<std::pair<double, Pose2>> bends;
      for (const Turn& turn : world.turns) {
        const double t = (turn.at_m - from.x_m) / (to.x_m - from.x_m);
        if (!(t > 0.0 && t < 1.0)) continue;
        // On the mitre of the bend both legs agree about how far left of the middle a point is.
        const double left = from.y_m + t * (to.y_m - from.y_m);
        const Pose2 bend = plan.at(turn.at_m, left);  // still in the frame of the leg before
        const double mitre = left * std::tan(turn.angle_rad / 2);
        bends.emplace_back(t, transform(bend, Pose2{-mitre, 0.0, 0.0}));
      }
      std::sort(bends.begin(), bends.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      for (const auto& bend : bends) push(bend.second);
    }
    push(plan.at(to.x_m, to.y_m));
  }
  return path;
}

}  // namespace striate::simulator
