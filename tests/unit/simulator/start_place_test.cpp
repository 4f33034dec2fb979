#include "striate/platform/simulator/start_place.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/base/user_error.hpp"

namespace striate::simulator {
namespace {

using testing::HasSubstr;

TEST(CheckPlace, IsWithinTheWallsAndFree) {
  World world;
  world.length_m = 20.0;
  WorldObstacle box;
  box.name = "box_1";
  box.at = {6.0, 0.0};
  world.obstacles.push_back(box);
  const ConvexShape body = disc({0.0, 0.0}, 0.2);
  EXPECT_NO_THROW(check_place(world, "--at", {3.0, 0.2, 0.5}, body));
  const auto refused = [&](const Pose2& at) -> std::string {
    try {
      check_place(world, "--at", at, body);
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refused({6.1, 0.1, 0.0}), HasSubstr("--at: 6.1 m, 0.1 m overlaps box_1"));
  EXPECT_THAT(refused({3.0, world.width_m / 2.0 - 0.1, 0.0}), HasSubstr("overlaps a wall"));
  EXPECT_THAT(refused({-0.1, 0.0, 0.0}), HasSubstr("lies outside"));
  EXPECT_THAT(refused({world.length_m + 0.5, 0.0, 0.0}), HasSubstr("lies outside"));
  EXPECT_THAT(refused({3.0, 9.0, 0.0}), HasSubstr("lies outside"));
  world.obstacles[0].appears_after_m = 3.0;
  EXPECT_NO_THROW(check_place(world, "--at", {6.1, 0.1, 0.0}, body)) << "it is not there yet";
}

}  // namespace
}  // namespace striate::simulator
