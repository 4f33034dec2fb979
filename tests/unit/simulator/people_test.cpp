#include "striate/platform/simulator/people.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace striate::simulator {
namespace {

World shipped(const std::string& name) {
  return load_world(STRIATE_SOURCE_DIR "/config/worlds/" + name + ".yaml");
}

TEST(People, PassARobotThatStandsInTheMiddle) {
  World world;
  world.length_m = 30.0;
  world.walks.push_back({{{25.0, 0.0}, {3.0, 0.0}}, 1.2, 0.0, false});
  const FloorPlan plan = build_floor_plan(world);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    People people(world, plan, RobotDescription{}, seed);
    for (int step = 1; step <= 4500; ++step) {
      people.step(0.01 * step, 0.01, {{12.0, 0.0, 0.0}, 0.0, 0.0});
    }
    EXPECT_LT(people.slots()[0].pose.x_m, 5.0)
        << "seed " << seed << " y " << people.slots()[0].pose.y_m;
  }
}

TEST(People, GoRoundWhatStandsInTheirWay) {
  World world;
  world.length_m = 30.0;
  WorldObstacle table;
  table.kind = ObstacleKind::table;
  table.at = {12.0, 0.3};
  world.obstacles.push_back(table);
  world.walks.push_back({{{25.0, 0.3}, {3.0, 0.3}}, 1.0, 0.0, false});
  const FloorPlan plan = build_floor_plan(world);
  const StaticShape shape = standing_shapes(world, plan)[0];
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    People people(world, plan, RobotDescription{}, seed);
    for (int step = 1; step <= 4500; ++step) {
      people.step(0.01 * step, 0.01, {{1.0, -0.9, 0.0}, 0.0, 0.0});
      if (!people.present(0)) continue;
      const Point2 at{people.slots()[0].pose.x_m, people.slots()[0].pose.y_m};
      ASSERT_GT(distance_m(shape.shape, disc(at, 0.0)), kPersonRadius_m - 0.06) << step;
    }
    EXPECT_LT(people.slots()[0].pose.x_m, 5.0)
        << "seed " << seed << " y " << people.slots()[0].pose.y_m;
  }
}

TEST(People, WalkRoundBends) {
  World world;
  world.length_m = 30.0;
  world.turns = {{10.0, radians(90.0)}, {20.0, radians(-90.0)}};
  world.walks.push_back({{{28.0, 0.5}, {2.0, -0.5}}, 1.2, 0.0, false});
  const FloorPlan plan = build_floor_plan(world);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    People people(world, plan, RobotDescription{}, seed);
    for (int step = 1; step <= 4500; ++step) {
      people.step(0.01 * step, 0.01, {{0.5, 0.8, 0.0}, 0.0, 0.0});
      if (!people.present(0) || step % 20 != 0) continue;
      const Point2 at{people.slots()[0].pose.x_m, people.slots()[0].pose.y_m};
      ASSERT_TRUE(inside_polygon(at, plan.outline)) << at.x_m << ", " << at.y_m;
    }
    EXPECT_NEAR(plan.along(people.slots()[0].pose).x_m, 2.0, 0.5) << "seed " << seed;
  }
}

TEST(People, GetThroughTheShippedCorridors) {
  for (const char* name : {"corridor_a", "corridor_b", "corridor_c"}) {
    const World world = shipped(name);
    const FloorPlan plan = build_floor_plan(world);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      People people(world, plan, RobotDescription{}, seed);
      for (int step = 1; step <= 30000; ++step) {
        people.step(0.01 * step, 0.01, {{1.0, -0.8, 0.0}, 0.0, 0.0});
      }
      for (std::size_t slot = 0; slot < world.walks.size(); ++slot) {
        if (world.walks[slot].repeat) continue;
        EXPECT_FALSE(people.present(slot))
            << name << " seed " << seed << " " << people.name(slot) << " is still at "
            << people.slots()[slot].pose.x_m << ", " << people.slots()[slot].pose.y_m;
      }
    }
  }
}

TEST(People, DifferFromSeedToSeedAndNeverWithinOne) {
  const World world = shipped("corridor_a");
  const FloorPlan plan = build_floor_plan(world);
  const auto places = [&](std::uint64_t seed) {
    People people(world, plan, RobotDescription{}, seed);
    std::vector<double> result;
    for (int step = 1; step <= 6000; ++step) {
      people.step(0.01 * step, 0.01, {{5.0 + 0.003 * step, 0.0, 0.0}, 0.3, 0.0});
      if (step % 100 == 0) {
        for (const PersonState& person : people.states()) result.push_back(person.pose.x_m);
      }
    }
    return result;
  };
  EXPECT_EQ(places(3), places(3));
  EXPECT_NE(places(3), places(4));
}

}  // namespace
}  // namespace striate::simulator
