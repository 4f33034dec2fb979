#include "striate/platform/simulator/low_shapes.hpp"

#include "striate/platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {
namespace {

// As the renderer draws them.
constexpr double kTableLeg_m = 0.055;
constexpr double kTableLegIn_m =
    0.03;                              ///< from the top's edge to the leg, as the renderer draws it
constexpr double kChairLeg_m = 0.026;  ///< thickness, as the renderer draws it
/// From the seat's edge to the leg, as the renderer draws it
constexpr double kChairLegIn_m = 0.022;
constexpr double kShin_m = 0.11;    ///< of a sitter, as the renderer draws it
constexpr double kPotShare = 0.48;  ///< of a plant's width, as the renderer draws it

std::vector<ConvexShape> low_outline(const WorldObstacle& obstacle, const FloorPlan& plan) {
  Pose2 pose = plan.at(obstacle.at.x_m, obstacle.at.y_m);
  pose.heading_rad += obstacle.turn_rad;
  const ObstacleSize size = size_of(obstacle);
  if (obstacle.kind == ObstacleKind::stairs) return {};
  if (obstacle.kind == ObstacleKind::sitter) {  // shins, and the chair's legs behind them
    std::vector<ConvexShape> legs;
    for (const double y : {-1.0, 1.0}) {
      const Point2 shin = transform(pose, Point2{0.4 * size.x_m, 0.23 * y * size.y_m});
      legs.push_back(rectangle({shin.x_m, shin.y_m, pose.heading_rad}, kShin_m, kShin_m));
      for (const double x : {-0.45, 0.05}) {
        const Point2 leg = transform(pose, Point2{x * size.x_m, 0.4 * y * size.y_m});
        legs.push_back(rectangle({leg.x_m, leg.y_m, pose.heading_rad}, kChairLeg_m, kChairLeg_m));
      }
    }
    return legs;
  }
  if (obstacle.kind == ObstacleKind::glass) {  // its posts
    std::vector<ConvexShape> posts;
    for (const double end : {-1.0, 1.0}) {
      const Point2 at = transform(pose, Point2{end * (size.x_m - kGlassPost_m) / 2, 0.0});
      posts.push_back(rectangle({at.x_m, at.y_m, pose.heading_rad}, kGlassPost_m, size.y_m));
    }
    return posts;
  }
  if (obstacle.kind == ObstacleKind::plant) {
    return {moved({round_footprint(kPotShare * size.x_m, kPotShare * size.y_m), 0.0}, pose)};
  }
  if (obstacle.kind != ObstacleKind::table && obstacle.kind != ObstacleKind::chair) {
    return obstacle_outline(obstacle, plan);
  }
  const bool table = obstacle.kind == ObstacleKind::table;
  const double leg = table ? kTableLeg_m : kChairLeg_m;
  const double in = table ? kTableLegIn_m : kChairLegIn_m;
  std::vector<ConvexShape> legs;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Point2 at =
          transform(pose, Point2{x * ((size.x_m - leg) / 2 - in), y * ((size.y_m - leg) / 2 - in)});
      legs.push_back(rectangle({at.x_m, at.y_m, pose.heading_rad}, leg, leg));
    }
  }
  return legs;
}

}  // namespace

std::vector<StaticShape> glass_shapes(const World& world, const FloorPlan& plan) {
  World panes = with_obstacles(
      world, [](const WorldObstacle& thing) { return thing.kind == ObstacleKind::glass; });
  panes.pillars.clear();
  return standing_shapes(panes, plan);
}

std::vector<StaticShape> low_shapes(const World& world, const FloorPlan& plan) {
  World pillars_alone;
  pillars_alone.pillars = world.pillars;
  std::vector<StaticShape> shapes = standing_shapes(pillars_alone, plan);
  for (const WorldObstacle& obstacle : world.obstacles) {
    for (ConvexShape& shape : low_outline(obstacle, plan)) {
      shapes.push_back({obstacle.name, std::move(shape), obstacle.at, 0.0});
    }
  }
  return shapes;
}

}  // namespace striate::simulator
