#include <gtest/gtest.h>

#include <cmath>

#include "striate/behaviours/control/floor_field.hpp"
#include "striate/behaviours/control/footprint.hpp"
#include "striate/behaviours/navigation/path_planner.hpp"
#include "striate/behaviours/navigation/steering.hpp"

namespace striate::behaviours {
namespace {

constexpr double kHalfWidth_m = 0.2125;

class Planning : public testing::Test {
 protected:
  void SetUp() override { fill(-1.0, 5.0, -1.15, 1.15, -2.0F); }
  void fill(double x0, double x1, double y0, double y1, float evidence) {
    const memory::GridCell a = memory::LocalGrid::cell_of({x0, y0});
    const memory::GridCell b = memory::LocalGrid::cell_of({x1, y1});
    for (int y = a.y; y <= b.y; ++y) {
      for (int x = a.x; x <= b.x; ++x) grid.add({x, y}, evidence, {});
    }
  }
  void box(double x0, double x1, double y0, double y1) { fill(x0, x1, y0, y1, 7.0F); }
  const Path& plan(double wanted_left_m = 0.0) {
    field.update(grid);
    PlanRequest request;
    request.half_width_m = kHalfWidth_m;
    request.least_margin_m = 0.06;
    request.wanted_left_m = wanted_left_m;
    request.half_corridor_m = 1.2;
    return planner.plan(field, {}, request);
  }
  static double y_at(const Path& way, double x_m) {
    double best = 1e9;
    double y_m = 0.0;
    for (std::size_t i = 0; i < way.count; ++i) {
      if (std::abs(way.points[i].x_m - x_m) >= best) continue;
      best = std::abs(way.points[i].x_m - x_m);
      y_m = way.points[i].y_m;
    }
    return y_m;
  }
  memory::LocalGrid grid;
  FloorField field;
  PathPlanner planner;
};

TEST_F(Planning, TheFieldTellsDistancesToEdges) {
  box(2.0, 2.3, -0.3, 0.3);
  field.update(grid);
  EXPECT_NEAR(field.clearance_m({1.0, 0.0}), 1.0, 0.08);
  EXPECT_EQ(field.clearance_m({2.1, 0.0}), 0.0);
  EXPECT_NEAR(field.seen_clearance_m({1.0, 0.85}), 0.3, 0.06);
  EXPECT_EQ(field.seen_clearance_m({1.0, 1.5}), 0.0);
  EXPECT_EQ(field.state({1.0, 1.5}), memory::CellState::unknown);
}

TEST_F(Planning, ASpeckIsNoObstacleUnlessItsEvidenceIsStrong) {
  const memory::GridCell speck = memory::LocalGrid::cell_of({2.0, 0.0});
  grid.add(speck, 4.0F, {});  // 2.0
  field.update(grid);
  EXPECT_GT(field.clearance_m({2.0, 0.0}), 0.5);
  grid.add(speck, 1.4F, {});
  field.update(grid);
  EXPECT_EQ(field.clearance_m(memory::LocalGrid::centre_of(speck)), 0.0);
}

TEST_F(Planning, AnEmptyCorridorIsDrivenStraight) {
  const Path& way = plan();
  ASSERT_TRUE(way.found && way.reaches_far);
  for (std::size_t i = 0; i < way.count; ++i) EXPECT_NEAR(way.points[i].y_m, 0.0, 0.05);
}

TEST_F(Planning, GoesRoundABoxOnTheRoomierSide) {
  box(2.0, 2.4, -1.2, 0.1);
  const Path& way = plan();
  ASSERT_TRUE(way.reaches_far);
  EXPECT_GT(y_at(way, 2.2), 0.1 + kHalfWidth_m + 0.06);
}

TEST_F(Planning, TakesAGapOfThreeQuartersOfAMetreAndNotOneOfHalf) {
  box(2.0, 2.3, 0.375, 1.4);
  box(2.0, 2.3, -1.4, -0.375);
  EXPECT_TRUE(plan().reaches_far);
  box(2.0, 2.3, 0.25, 1.4);
  box(2.0, 2.3, -1.4, -0.25);
  const Path& way = plan();
  EXPECT_FALSE(way.reaches_far);
  EXPECT_LT(way.progress_m, 2.0);  // but it may go nearer
}

TEST_F(Planning, DoesNotEvadeOverUnknownFloorBeyondTheWalls) {
  box(2.0, 2.3, -0.9, 1.2);  // leaves 0.3 m to the right; beyond it nothing was ever seen
  const Path& way = plan();
  if (way.reaches_far) {
    EXPECT_LT(std::abs(y_at(way, 2.15)), 1.6);
  }
  PlanRequest request;
  request.half_width_m = kHalfWidth_m;
  request.least_margin_m = 0.06;
  request.right_wall_m = 1.2;  // a remembered wall shuts it
  request.left_wall_m = 1.2;
  EXPECT_FALSE(planner.plan(field, {}, request).reaches_far);
}

TEST_F(Planning, KeepsTheSideItChose) {
  box(2.0, 2.4, -0.25, 0.30);  // a little roomier on the right
  ASSERT_LT(y_at(plan(), 2.2), 0.0);
  box(2.0, 2.4, -0.35, 0.30);  // now the other side is, by as little
  planner.forget_choice();
  ASSERT_GT(y_at(plan(), 2.2), 0.0);  // as one sees who comes anew
  grid.forget();
  SetUp();
  planner.forget_choice();
  box(2.0, 2.4, -0.25, 0.30);
  plan();
  box(2.0, 2.4, -0.35, 0.30);
  EXPECT_LT(y_at(plan(), 2.2), 0.0);
}

TEST_F(Planning, KeepsTheWantedLine) {
  EXPECT_NEAR(y_at(plan(0.5), 4.0), 0.5, 0.22);
}

TEST(FootprintTest, TellsDistanceFromTheOutline) {
  const Footprint footprint{RobotDescription{}};
  EXPECT_NEAR(footprint.distance_m({0.31, 0.0}), 0.10, 1e-9);
  EXPECT_NEAR(footprint.distance_m({-0.40, 0.0}), 0.10, 1e-9);
  EXPECT_NEAR(footprint.distance_m({0.0, -0.3125}), 0.10, 1e-9);
  EXPECT_NEAR(footprint.distance_m({0.24, 0.2525}), 0.05, 1e-9);
  EXPECT_LT(footprint.distance_m({0.0, 0.0}), -0.2);
}

TEST(FootprintTest, AnArcEndsWhereManySmallStepsEnd) {
  Pose2 small{1.0, 2.0, 0.3};
  for (int i = 0; i < 1000; ++i) small = transform(small, Pose2{0.0004, 0.0, 0.0006});
  const Pose2 arc = along_arc({1.0, 2.0, 0.3}, 0.4, 0.6, 1.0);
  EXPECT_NEAR(arc.x_m, small.x_m, 1e-3);
  EXPECT_NEAR(arc.y_m, small.y_m, 1e-3);
  EXPECT_NEAR(arc.heading_rad, small.heading_rad, 1e-9);
}

TEST_F(Planning, SteeringFollowsTheWayAndNeverThroughAThing) {
  box(0.8, 1.2, -1.2, 0.05);
  const RobotDescription robot;
  const Steering steering(robot, 0.12);
  const Drive drive = steering.follow(plan(), field, {}, {0.3, 0.04, false});
  ASSERT_TRUE(drive.possible);
  EXPECT_GT(drive.turn_rad_s, 0.1);
  for (double t = 0.0; t < 1.4; t += 0.1) {
    const Pose2 pose = along_arc({}, drive.forward_m_s, drive.turn_rad_s, t);
    EXPECT_GT(steering.footprint().clearance_m(field, pose), 0.0) << t;
  }
}

TEST_F(Planning, SteeringTurnsOnTheSpotWhenTheWayLeadsBehind) {
  plan();
  const RobotDescription robot;
  const Steering steering(robot, 0.12);
  const Drive drive = steering.follow(planner.way(), field, {0.0, 0.0, 2.0}, {0.4, 0.04, false});
  ASSERT_TRUE(drive.possible);
  EXPECT_EQ(drive.forward_m_s, 0.0);
  EXPECT_LT(drive.turn_rad_s, -0.2);
}

}  // namespace
}  // namespace striate::behaviours
