#include "striate/platform/simulator/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "striate/platform/simulator/simulated_pioneer.hpp"
#include "tests/unit/simulator/fake_images.hpp"

namespace striate::simulator {
namespace {

/// Drives straight past a box that leaves this much room beside the robot.
const Judge& drive_past(SimulatedPioneer& robot) {
  Senses senses;
  do {
    robot.send({.forward_m_s = 0.5});
  } while (robot.sense(senses));
  return robot.judge();
}

World world_with_box(double clearance_m) {
  World world = straight_world(10.0);
  WorldObstacle box;
  box.kind = ObstacleKind::box;
  box.name = "the_box";
  box.at = {5.0, 0.2125 + clearance_m + 0.25};
  world.obstacles.push_back(box);
  return world;
}

TEST(Judge, TellsANearMissOnceWithItsPlaceAndClearance) {
  SimulatedPioneer robot(world_with_box(0.06), 1, exact_start(), nullptr);
  const Judge& judge = drive_past(robot);
  EXPECT_EQ(judge.outcome(), Verdict::reached_goal);
  ASSERT_EQ(judge.near_misses().size(), 1u);
  EXPECT_EQ(judge.near_misses()[0].to, "the_box");
  EXPECT_NEAR(judge.near_misses()[0].clearance_m, 0.06, 0.002);
  EXPECT_NEAR(judge.near_misses()[0].along_m, 5.0, 0.6);
  EXPECT_FALSE(judge.near_misses()[0].moving);
  EXPECT_NEAR(judge.nearest_pass_m(), 0.06, 0.002);
  EXPECT_TRUE(judge.collisions().empty());
}

TEST(Judge, AWidePassIsNoNearMiss) {
  SimulatedPioneer robot(world_with_box(0.2), 1, exact_start(), nullptr);
  const Judge& judge = drive_past(robot);
  EXPECT_TRUE(judge.near_misses().empty());
  EXPECT_NEAR(judge.nearest_pass_m(), 0.2, 0.002);
}

TEST(Judge, AGrazeIsACollisionAndNoNearMiss) {
  SimulatedPioneer robot(world_with_box(-0.03), 1, exact_start(), nullptr);
  const Judge& judge = drive_past(robot);
  EXPECT_EQ(judge.outcome(), Verdict::collided);
  ASSERT_EQ(judge.collisions().size(), 1u);
  EXPECT_EQ(judge.collisions()[0].hit, "the_box");
  EXPECT_TRUE(judge.near_misses().empty());
}

TEST(Judge, LessThanTwoMillimetresIsATouchByTheExactDistance) {
  for (const double clearance_m : {0.0005, 0.001, 0.0015}) {
    SimulatedPioneer robot(world_with_box(clearance_m), 1, exact_start(), nullptr);
    EXPECT_EQ(drive_past(robot).outcome(), Verdict::collided) << clearance_m;
  }
  SimulatedPioneer robot(world_with_box(0.004), 1, exact_start(), nullptr);
  const Judge& judge = drive_past(robot);
  EXPECT_EQ(judge.outcome(), Verdict::reached_goal);
  EXPECT_NEAR(judge.nearest_pass_m(), 0.004, 0.001);
}

TEST(Judge, KeepsThePathForDrawing) {
  SimulatedPioneer robot(straight_world(10.0), 1, exact_start(), nullptr);
  const Judge& judge = drive_past(robot);
  ASSERT_GT(judge.path().size(), 50u);
  for (std::size_t i = 1; i < judge.path().size(); ++i) {
    EXPECT_NEAR(judge.path()[i].time_s - judge.path()[i - 1].time_s, 0.2, 1e-6);
  }
  EXPECT_NEAR(judge.path().back().pose.x_m, 9.0, 0.15);
  EXPECT_NEAR(judge.distance_driven_m(), 8.0, 0.02);
}

TEST(Judge, APersonWhoIsRunDownCountsAsHitAndStanding) {
  World world = straight_world(10.0);
  world.standers.push_back({{5.0, 0.0}, 0.0});
  SimulatedPioneer robot(world, 1, exact_start(), nullptr);
  const Judge& judge = drive_past(robot);
  ASSERT_EQ(judge.collisions().size(), 1u);
  EXPECT_EQ(judge.collisions()[0].hit, "person_1");
  EXPECT_FALSE(judge.collisions()[0].moving);
  EXPECT_NEAR(judge.collisions()[0].along_m, 5.0 - 0.25 - 0.21, 0.01);
}

TEST(Judge, MeasuresProgressAlongABentCorridor) {
  World world = straight_world(20.0);
  world.turns.push_back({3.0, radians(90.0)});
  world.start = {5.0, 0.3, 0.0};
  world.goal_beyond_m = 8.0;
  SimulatedPioneer robot(world, 1, exact_start(), nullptr);
  EXPECT_NEAR(robot.scene().robot.x_m, 2.7, 1e-6);
  EXPECT_NEAR(robot.scene().robot.y_m, 2.0, 1e-6);
  const Judge& judge = drive_past(robot);
  EXPECT_EQ(judge.outcome(), Verdict::reached_goal);
  EXPECT_NEAR(judge.in_corridor().y_m, 0.3, 0.01);
  EXPECT_NEAR(judge.distance_driven_m(), 3.0, 0.02);
}

}  // namespace
}  // namespace striate::simulator
