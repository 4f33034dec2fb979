#include "striate/platform/simulator/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "striate/platform/simulator/clearance_map.hpp"
#include "striate/platform/simulator/random.hpp"

namespace striate::simulator {
namespace {

TEST(Shapes, TheFootprintIsThePioneersOctagon) {
  const ConvexShape footprint = robot_footprint(RobotDescription{});
  ASSERT_EQ(footprint.corners.size(), 8u);
  double front = 0.0;
  double rear = 0.0;
  double side = 0.0;
  int diagonals = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const Point2& a = footprint.corners[i];
    const Point2& b = footprint.corners[(i + 1) % 8];
    front = std::max(front, a.x_m);
    rear = std::min(rear, a.x_m);
    side = std::max(side, a.y_m);
    if (a.x_m != b.x_m && a.y_m != b.y_m) {
      ++diagonals;
      EXPECT_NEAR(distance_m(a, b), 0.12, 1e-9);
    }
  }
  EXPECT_DOUBLE_EQ(front, 0.21);
  EXPECT_DOUBLE_EQ(rear, -0.30);
  EXPECT_DOUBLE_EQ(side, 0.2125);
  EXPECT_EQ(diagonals, 4);
}

TEST(Shapes, TheFootprintFollowsTheDescription) {
  RobotDescription robot;
  robot.front_m = robot.rear_m = robot.half_width_m = 0.18;
  robot.corner_m = 0.15;
  const ConvexShape round = robot_footprint(robot);
  for (const Point2& corner : round.corners) {
    EXPECT_NEAR(std::hypot(corner.x_m, corner.y_m), 0.19, 0.01) << "nearly a disc";
  }
}

TEST(Shapes, DistanceOfDiscsLinesAndRectangles) {
  EXPECT_NEAR(distance_m(disc({0, 0}, 0.2), disc({1, 0}, 0.3)), 0.5, 1e-12);
  EXPECT_NEAR(distance_m(disc({0, 0.5}, 0.2), {{{-1, 0}, {1, 0}}, 0.0}), 0.3, 1e-12);
  const ConvexShape square = rectangle({0, 0, 0}, 1.0, 1.0);
  EXPECT_NEAR(distance_m(square, rectangle({2, 0, radians(45.0)}, 1.0, 1.0)), 1.5 - std::sqrt(0.5),
              1e-12);
  EXPECT_EQ(distance_m(square, disc({0, 0}, 0.1)), 0.0);
  EXPECT_EQ(distance_m(disc({0.1, 0}, 0.0), square), 0.0);
  EXPECT_EQ(distance_m(square, rectangle({0.8, 0.8, 0.3}, 1.0, 1.0)), 0.0);
  EXPECT_EQ(distance_m(square, {{{-2, 0}, {2, 0}}, 0.0}), 0.0) << "a line right through";
}

TEST(Shapes, DistanceIsTheNearestOfAllPairsOfPoints) {
  const Random random(1, Purpose::walk);
  for (std::uint64_t trial = 0; trial < 50; ++trial) {
    const auto draw = [&](std::uint64_t i) { return random.between(10 * trial + i, -2.0, 2.0); };
    const ConvexShape a = rectangle({draw(0), draw(1), draw(2)}, 1.0, 0.4);
    const ConvexShape b = moved(robot_footprint(RobotDescription{}), {draw(3), draw(4), draw(5)});
    double nearest = 1e9;
    for (std::size_t i = 0; i < a.corners.size(); ++i) {
      for (std::size_t j = 0; j < b.corners.size(); ++j) {
        for (int s = 0; s <= 200; ++s) {
          const Point2& p = a.corners[i];
          const Point2& q = a.corners[(i + 1) % a.corners.size()];
          const Point2 at{p.x_m + s / 200.0 * (q.x_m - p.x_m), p.y_m + s / 200.0 * (q.y_m - p.y_m)};
          nearest = std::min(nearest, distance_to_segment_m(at, b.corners[j],
                                                            b.corners[(j + 1) % b.corners.size()]));
        }
      }
    }
    const double measured = distance_m(a, b);
    if (measured > 0.0) {
      EXPECT_NEAR(measured, nearest, 1e-3);
    } else {
      const bool within =
          inside_polygon(a.corners[0], b.corners) || inside_polygon(b.corners[0], a.corners);
      EXPECT_TRUE(nearest < 0.01 || within) << trial;
    }
    EXPECT_NEAR(measured, distance_m(b, a), 1e-12);
  }
}

TEST(ClearanceMap, KnowsHowFarWallsAndThingsAre) {
  World world;
  world.length_m = 10.0;
  world.pillars.push_back({{5.0, 0.0}, 0.4});
  const ClearanceMap map(world, build_floor_plan(world));
  EXPECT_NEAR(map.at({2.0, 0.0}), 1.2, 0.02);
  EXPECT_NEAR(map.at({2.03, 0.87}), 0.33, 0.02);
  EXPECT_NEAR(map.at({4.0, 0.0}), 0.8, 0.02);
  EXPECT_LT(map.at({5.0, 0.05}), 0.02);
  EXPECT_EQ(map.at({5.0, 1.5}), 0.0);
  EXPECT_EQ(map.at({-50.0, 0.0}), 0.0);
}

TEST(ClearanceMap, FindsAWayRoundAPillarAndNoneThroughAWall) {
  World world;
  world.length_m = 10.0;
  world.pillars.push_back({{5.0, 0.0}, 0.8});
  const ClearanceMap map(world, build_floor_plan(world));
  const auto way = map.way({1.0, 0.0}, {9.0, 0.0}, 0.25);
  ASSERT_TRUE(way.has_value());
  EXPECT_GE(way->size(), 3u);
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < way->size(); ++i) {
    EXPECT_TRUE(map.straight_is_free((*way)[i], (*way)[i + 1], 0.22));
    length += distance_m((*way)[i], (*way)[i + 1]);
  }
  EXPECT_LT(length, 8.6);
  EXPECT_FALSE(map.way({1.0, 0.0}, {9.0, 0.0}, 0.45).has_value()) << "0.8 m are left at each side";
}

}  // namespace
}  // namespace striate::simulator
