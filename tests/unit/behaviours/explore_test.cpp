#include "striate/behaviours/explore.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "striate/behaviours/return_to_start.hpp"
#include "tests/reference/flat_layouts.hpp"
#include "tests/reference/flat_run.hpp"

namespace striate::behaviours {
namespace {

/// Along x to 10 m, then to the left to y = 9 m; 2.4 m wide, shut at both ends.
flat::Layout bent_corridor() {
  flat::Layout layout;
  const std::vector<Point2> outline{{-1.5, -1.2}, {10.2, -1.2}, {10.2, 9.0},
                                    {7.8, 9.0},   {7.8, 1.2},   {-1.5, 1.2}};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    layout.faces.push_back({outline[i], outline[(i + 1) % outline.size()], 0.0, 2.7, false});
  }
  layout.goal_x_m = 1e6;
  return layout;
}

TEST(Explore, GoesRoundTheBendWithoutTouchingAndMapsMostOfIt) {
  for (std::uint64_t seed = 61; seed <= 62; ++seed) {
    flat::Loop loop(bent_corridor(), seed);
    Explore explore({}, loop.robot);
    double farthest_m = 0.0;
    const flat::RunResult result = loop.run(explore, 400.0, [&](const Wish&) {
      farthest_m = std::max(farthest_m, loop.world.pose().y_m);
    });
    EXPECT_NE(result.progress, Progress::failed) << "seed " << seed << " " << result.why;
    EXPECT_FALSE(result.touched) << "seed " << seed;
    EXPECT_GT(farthest_m, 3.0) << "seed " << seed;
    EXPECT_GT(explore.known().area_m2(), 30.0) << "seed " << seed;
  }
}

/// A robot that has explored to beyond the bend; nothing where it has not come so far. How long it
/// goes on looking at edges there is another question.
std::unique_ptr<flat::Loop> beyond_the_bend(std::uint64_t seed) {
  auto loop = std::make_unique<flat::Loop>(bent_corridor(), seed);
  Explore explore({}, loop->robot);
  while (loop->world.pose().y_m < 4.0) {
    if (loop->world.time_s() > 200.0) return nullptr;
    loop->cycle(explore, "explore");
  }
  return loop;
}

TEST(Explore, TheWayBackGoesRoundTheBendToo) {
  bool came_so_far = false;
  for (std::uint64_t seed = 65; seed <= 70 && !came_so_far; ++seed) {
    const std::unique_ptr<flat::Loop> loop = beyond_the_bend(seed);
    if (loop == nullptr) continue;
    came_so_far = true;
    ReturnToStart back({}, loop->robot);
    back.start(loop->memory);
    const flat::RunResult result = loop->run(back, loop->world.time_s() + 150.0);
    EXPECT_EQ(result.progress, Progress::succeeded) << "seed " << seed << " " << result.why;
    EXPECT_FALSE(result.touched) << "seed " << seed;
    EXPECT_LT(std::hypot(loop->world.pose().x_m, loop->world.pose().y_m), 1.6) << "seed " << seed;
  }
  EXPECT_TRUE(came_so_far);
}

TEST(FrontierFinder, FindsNothingOnceAllIsKnownOrAvoided) {
  const RobotDescription robot;
  memory::LocalGrid grid;
  FloorField field;
  FrontierFinder finder(robot);
  finder.forget();
  for (int y = -40; y <= 40; ++y) {
    for (int x = -40; x <= 40; ++x) grid.add({x, y}, -2.0F, TimePoint{});
  }
  field.update(grid);
  const Frontier found = finder.find(field, {});
  ASSERT_TRUE(found.found);
  EXPECT_GT(std::hypot(found.place.x_m, found.place.y_m), 1.3);
  finder.avoid(found.place);
  const Frontier other = finder.find(field, {});
  ASSERT_TRUE(other.found);
  EXPECT_GT(std::hypot(other.place.x_m - found.place.x_m, other.place.y_m - found.place.y_m), 0.6);
  for (int y = -45; y <= 45; ++y) {  // a wall round it all
    for (int x = -45; x <= 45; ++x) {
      if (std::max(std::abs(x), std::abs(y)) > 40) grid.add({x, y}, 3.5F, TimePoint{});
    }
  }
  field.update(grid);
  EXPECT_FALSE(finder.find(field, {}).found);
}

}  // namespace
}  // namespace striate::behaviours
