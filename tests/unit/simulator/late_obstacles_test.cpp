#include "striate/platform/simulator/late_obstacles.hpp"

#include <gtest/gtest.h>

#include "striate/platform/simulator/simulated_pioneer.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "tests/unit/simulator/fake_images.hpp"

namespace striate::simulator {
namespace {

World world_with(double at_m, double from_s, double after_m) {
  World world = straight_world();
  WorldObstacle box;
  box.name = "new_box";
  box.at = {at_m, 0.0};
  box.from_s = from_s;
  box.appears_after_m = after_m;
  world.obstacles.push_back(box);
  return world;
}

TEST(LateObstacles, ComeAfterTheirTimeAndTheirWay) {
  const World world = world_with(10.0, 60.0, 5.0);
  LateObstacles late(world, build_floor_plan(world));
  EXPECT_EQ(late.absent().size(), 1U);
  EXPECT_TRUE(late.step(59.0, 9.0, {}).empty());
  EXPECT_TRUE(late.step(61.0, 4.0, {}).empty());
  EXPECT_EQ(late.step(62.0, 5.0, {}).size(), 1U);
  EXPECT_TRUE(late.absent().empty());
  EXPECT_TRUE(late.step(63.0, 5.0, {}).empty()) << "once";
  ASSERT_EQ(late.put_down().size(), 1U);
  EXPECT_EQ(late.put_down()[0].time_s, 62.0);
}

TEST(LateObstacles, NeverComeWhereTheRobotCouldNotStop) {
  const World world = world_with(10.0, 0.0, 1.0);
  LateObstacles late(world, build_floor_plan(world));
  EXPECT_TRUE(late.step(50.0, 5.0, {10.0 - LateObstacles::kLeast_m + 0.1, 0.0, 0.0}).empty());
  EXPECT_EQ(late.step(51.0, 6.0, {10.0 + LateObstacles::kLeast_m + 0.1, 0.0, 0.0}).size(), 1U);
}

TEST(LateObstacles, AreSeenFeltAndJudgedOnlyOnceTheyAreThere) {
  FakeImages pictures;
  SimulatedPioneer robot(world_with(6.0, 4.0, 0.0), 1, {}, &pictures);
  Senses senses;
  const auto ahead_m = [&] {
    return senses.laser.readings[senses.laser.readings.size() / 2].distance_m;
  };
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(robot.sense(senses));
  EXPECT_EQ(pictures.scenes.back().absent.size(), 1U);
  EXPECT_GT(ahead_m(), 7.0);
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(robot.sense(senses));
  EXPECT_TRUE(pictures.scenes.back().absent.empty());
  EXPECT_LT(ahead_m(), 5.5);
  for (int i = 0; i < 200 && robot.judge().collisions().empty(); ++i) {
    robot.send({.forward_m_s = 0.5});
    robot.sense(senses);
  }
  ASSERT_EQ(robot.judge().collisions().size(), 1U);
  EXPECT_EQ(robot.judge().collisions()[0].hit, "new_box");
}

TEST(LateObstacles, AreReadFromAWorldFile) {
  config::Diagnostics diagnostics("w.yaml");
  const World world = parse_world(
      "striate_world: 1\nname: w\ncorridor: {length: 20 m}\nobstacles:\n"
      "  - {kind: table, at: [9 m, 0 m], from: 1 min}\n"
      "  - {kind: bin, at: [12 m, 0 m], appears_after: 20 m}\n",
      diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  ASSERT_EQ(world.obstacles.size(), 2U);
  EXPECT_EQ(world.obstacles[0].from_s, 60.0);
  EXPECT_EQ(world.obstacles[1].appears_after_m, 20.0);
}

}  // namespace
}  // namespace striate::simulator
