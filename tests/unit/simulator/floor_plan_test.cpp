#include <gtest/gtest.h>

#include <cmath>

#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/shapes.hpp"
#include "striate/platform/simulator/static_shapes.hpp"

namespace striate::simulator {
namespace {

double area_m2(const std::vector<Point2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    twice += a.x_m * b.y_m - b.x_m * a.y_m;
  }
  return twice / 2;
}

World corridor(double length_m) {
  World world;
  world.length_m = length_m;
  return world;
}

void expect_closed(const FloorPlan& plan) {
  for (std::size_t i = 0; i < plan.walls.size(); ++i) {
    const Point2& end = plan.walls[i].to;
    const Point2& next = plan.walls[(i + 1) % plan.walls.size()].from;
    EXPECT_EQ(end.x_m, next.x_m) << "wall " << i;
    EXPECT_EQ(end.y_m, next.y_m) << "wall " << i;
  }
}

TEST(FloorPlan, IsARectangleForAPlainCorridor) {
  const FloorPlan plan = build_floor_plan(corridor(10.0));
  ASSERT_EQ(plan.walls.size(), 4u);
  expect_closed(plan);
  EXPECT_NEAR(area_m2(plan.outline), 24.0, 1e-9);  // positive: counter-clockwise
}

TEST(FloorPlan, HasFourStepWallsAtAWidening) {
  World world = corridor(60.0);
  world.widenings.push_back({27.0, 34.0, 5.0});
  const FloorPlan plan = build_floor_plan(world);
  expect_closed(plan);
  EXPECT_NEAR(area_m2(plan.outline), 60.0 * 2.4 + 7.0 * 2.6, 1e-9);
  int steps = 0;
  for (const WallSegment& wall : plan.walls) {
    const bool across = wall.from.x_m == wall.to.x_m;
    if (across && wall.from.x_m > 1.0 && wall.from.x_m < 59.0) {
      ++steps;
      EXPECT_NEAR(std::abs(wall.to.y_m - wall.from.y_m), 1.3, 1e-9);
    }
  }
  EXPECT_EQ(steps, 4);
}

TEST(FloorPlan, AWidthThatReachesTheEndMakesAWiderEndWall) {
  World world = corridor(20.0);
  world.widenings.push_back({15.0, 20.0, 4.0});
  const FloorPlan plan = build_floor_plan(world);
  expect_closed(plan);
  EXPECT_NEAR(area_m2(plan.outline), 15.0 * 2.4 + 5.0 * 4.0, 1e-9);
}

TEST(FloorPlan, SplitsWallsWhereTheMaterialChanges) {
  World world = corridor(20.0);
  world.walls.push_back({Side::left, 5.0, 8.0, "brick"});
  const FloorPlan plan = build_floor_plan(world);
  expect_closed(plan);
  double brick_m = 0.0;
  for (const WallSegment& wall : plan.walls) {
    if (wall.material != "brick") continue;
    brick_m += distance_m(wall.from, wall.to);
    EXPECT_EQ(wall.side, Side::left);
    EXPECT_NEAR(wall.from.y_m, 1.2, 1e-12);
    EXPECT_NEAR(wall.along_m, 8.0, 1e-12);  // the left wall runs backwards
  }
  EXPECT_NEAR(brick_m, 3.0, 1e-9);
}

TEST(FloorPlan, BendsToTheLeftAndToTheRight) {
  for (const double angle : {radians(90.0), radians(-90.0), radians(30.0), radians(-120.0)}) {
    World world = corridor(20.0);
    world.turns.push_back({8.0, angle});
    const FloorPlan plan = build_floor_plan(world);
    expect_closed(plan);
    ASSERT_EQ(plan.centre_line.size(), 3u);
    EXPECT_NEAR(plan.centre_line[1].x_m, 8.0, 1e-12);
    EXPECT_NEAR(plan.centre_line[2].x_m, 8.0 + 12.0 * std::cos(angle), 1e-12);
    EXPECT_NEAR(plan.centre_line[2].y_m, 12.0 * std::sin(angle), 1e-12);
    // What the inner side loses the outer side gains.
    EXPECT_NEAR(area_m2(plan.outline), 48.0, 1e-9);
    for (const Point2& corner : plan.outline) {
      double nearest = 1e9;
      for (std::size_t i = 0; i + 1 < 3; ++i) {
        nearest = std::min(
            nearest, distance_to_segment_m(corner, plan.centre_line[i], plan.centre_line[i + 1]));
      }
      EXPECT_GE(nearest, 1.2 - 1e-9);
    }
  }
}

TEST(FloorPlan, TurnsCorridorCoordinatesIntoThePlanAndBack) {
  World world = corridor(30.0);
  world.turns.push_back({8.0, radians(90.0)});
  world.turns.push_back({18.0, radians(-60.0)});
  const FloorPlan plan = build_floor_plan(world);
  const Pose2 second = plan.at(10.0, 0.5);
  EXPECT_NEAR(second.x_m, 7.5, 1e-12);
  EXPECT_NEAR(second.y_m, 2.0, 1e-12);
  EXPECT_NEAR(second.heading_rad, radians(90.0), 1e-12);
  for (const double along : {0.5, 4.0, 6.5, 9.5, 12.0, 16.5, 20.0, 28.0}) {
    for (const double left : {-1.0, 0.0, 0.7}) {
      Pose2 pose = plan.at(along, left);
      pose.heading_rad += 0.3;
      const Pose2 back = plan.along(pose);
      EXPECT_NEAR(back.x_m, along, 1e-9);
      EXPECT_NEAR(back.y_m, left, 1e-9);
      EXPECT_NEAR(back.heading_rad, 0.3, 1e-9);
    }
  }
}

TEST(FloorPlan, AWayAroundABendMeetsTheMitre) {
  World world = corridor(20.0);
  world.turns.push_back({8.0, radians(90.0)});
  const FloorPlan plan = build_floor_plan(world);
  const std::vector<Point2> path = plan_path(world, plan, {{4.0, 0.5}, {14.0, 0.5}});
  ASSERT_EQ(path.size(), 3u);
  EXPECT_NEAR(path[1].x_m, 7.5, 1e-9);
  EXPECT_NEAR(path[1].y_m, 0.5, 1e-9);
  EXPECT_NEAR(path[2].x_m, 7.5, 1e-9);
  EXPECT_NEAR(path[2].y_m, 6.0, 1e-9);
}

}  // namespace
}  // namespace striate::simulator
