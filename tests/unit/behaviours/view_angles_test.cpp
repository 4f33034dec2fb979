#include "striate/behaviours/view_angles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "striate/behaviours/look_around.hpp"
#include "striate/behaviours/look_at.hpp"
#include "striate/behaviours/registry.hpp"
#include "striate/behaviours/traverse_corridor.hpp"
#include "tests/reference/flat_layouts.hpp"
#include "tests/reference/flat_run.hpp"

namespace striate::behaviours {
namespace {

RobotDescription with_view(double degrees_wide, double camera_height_m = 1.2) {
  RobotDescription robot;
  robot.view_rad = radians(degrees_wide);
  robot.camera_height_m = camera_height_m;
  return robot;
}

/// Where the lowest ray of a 4:3 image meets the floor.
double floor_from_m(const RobotDescription& robot, double tilt_rad) {
  const double half_rad = std::atan(0.75 * std::tan(0.5 * robot.view_rad));
  return robot.camera_height_m / std::tan(half_rad - tilt_rad);
}

TEST(ViewAngles, OfThePioneersCameraAreItsOwnToTheLastBit) {
  EXPECT_EQ(same_floor_tilt({}, -0.58), -0.58);
  EXPECT_EQ(same_floor_tilt({}, -0.42), -0.42);
  EXPECT_EQ(pan_while_driving({}), 0.16);
}

TEST(ViewAngles, EveryCameraSeesTheSameFloor) {
  for (const double height_m : {0.6, 1.2, 1.6}) {
    for (const double view_deg : {30.0, 43.0, 60.0, 90.0}) {
      const RobotDescription robot = with_view(view_deg, height_m);
      EXPECT_NEAR(floor_from_m(robot, same_floor_tilt(robot, -0.58)), floor_from_m({}, -0.58), 1e-9)
          << view_deg << " deg at " << height_m << " m";
    }
  }
}

TEST(ViewAngles, AWiderViewLetsTheHeadTurnFartherAndAWiderRobotLess) {
  EXPECT_GT(pan_while_driving(with_view(60.0)), 0.3);
  EXPECT_EQ(pan_while_driving(with_view(20.0)), 0.0);
  RobotDescription wide;
  wide.half_width_m = 0.3;
  EXPECT_LT(pan_while_driving(wide), 0.16);
}

TEST(ViewAngles, TheHeadRestsAsTheRobotSays) {
  RobotDescription robot;
  robot.resting_tilt_rad = -0.11;
  const memory::ShortTermMemory memory({}, robot);
  EXPECT_EQ(standing_wish(memory, "").tilt_rad, -0.11);
  config::Diagnostics diagnostics("test");
  const auto look = find_behaviour("look_at")->make({}, diagnostics, robot);
  look->start(memory);
  EXPECT_EQ(look->tick(memory).tilt_rad, -0.11);
}

TEST(ViewAngles, LookingNearGoesAsFarDownAsTheCameraNeeds) {
  const RobotDescription wide = with_view(70.0);
  const memory::ShortTermMemory memory({}, wide);
  LookAround look({}, wide);
  look.start(memory);
  EXPECT_NEAR(floor_from_m(wide, look.tick(memory).tilt_rad), floor_from_m({}, -0.5), 1e-9);
}

struct Eyes {
  double view_deg;
  double height_m;
  double resting_tilt_rad;
};

class OtherCameras : public testing::TestWithParam<Eyes> {};

TEST_P(OtherCameras, DriveRandomCorridorsWithoutTouching) {
  RobotDescription robot = with_view(GetParam().view_deg, GetParam().height_m);
  robot.resting_tilt_rad = GetParam().resting_tilt_rad;
  for (std::uint64_t seed = 1000; seed < 1004; ++seed) {
    flat::Loop loop(flat::random_corridor(seed, 20.0), seed, {}, robot);
    TraverseCorridor behaviour({}, loop.robot);
    const flat::RunResult result = loop.run(behaviour, 300.0);
    EXPECT_TRUE(result.reached) << "seed " << seed << ": x " << result.end.x_m << ", "
                                << (result.touched ? "touched" : result.why);
  }
}

INSTANTIATE_TEST_SUITE_P(WiderNarrowerLower, OtherCameras,
                         testing::Values(Eyes{60.0, 1.2, -0.10}, Eyes{35.0, 1.2, -0.28},
                                         Eyes{60.0, 0.9, 0.0}));

}  // namespace
}  // namespace striate::behaviours
