#include "striate/behaviours/traverse_corridor.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "striate/behaviours/avoid.hpp"
#include "striate/behaviours/turn_to.hpp"
#include "tests/reference/flat_layouts.hpp"
#include "tests/reference/flat_run.hpp"

namespace striate::behaviours {
namespace {

flat::Layout plain_corridor(double length_m) {
  flat::Layout layout;
  flat::Random random(1);
  flat::add_walls(layout, -1.5, length_m + 8.0, flat::kHalfCorridor_m, random, 0.0);
  layout.goal_x_m = length_m;
  return layout;
}

flat::RunResult traverse(const flat::Layout& layout, std::uint64_t seed, double limit_s = 300.0,
                         const TraverseCorridor::Settings& settings = {}) {
  flat::Loop loop(layout, seed);
  TraverseCorridor behaviour(settings, loop.robot);
  return loop.run(behaviour, limit_s);
}

std::string tell(const flat::RunResult& r) {
  return (r.touched ? "touched" : "did not arrive") + std::string(" at x ") +
         std::to_string(r.end.x_m) + " y " + std::to_string(r.end.y_m) + ": " + r.why;
}

class RandomCorridor : public testing::TestWithParam<int> {};

TEST_P(RandomCorridor, IsDrivenWithoutTouching) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  const flat::RunResult result = traverse(flat::random_corridor(seed, 20.0), seed);
  EXPECT_TRUE(result.reached) << tell(result);
}

INSTANTIATE_TEST_SUITE_P(TwentySeeds, RandomCorridor, testing::Range(1000, 1020));

TEST(TraverseCorridor, DrivesAnEmptyCorridorAtCruisingSpeedInTheMiddle) {
  flat::Loop loop(plain_corridor(20.0), 3);
  TraverseCorridor behaviour({}, loop.robot);
  double most_off = 0.0;
  const flat::RunResult result = loop.run(behaviour, 200.0, [&](const Wish&) {
    most_off = std::max(most_off, std::abs(loop.world.pose().y_m));
  });
  EXPECT_TRUE(result.reached) << tell(result);
  EXPECT_LT(result.duration_s, 20.0 / 0.45 + 12.0);
  EXPECT_LT(most_off, 0.30);
}

TEST(TraverseCorridor, GlancesAtTheFloorThatComesNextEveryTwoThirdsOfAMetre) {
  flat::Loop loop(plain_corridor(10.0), 3);
  TraverseCorridor behaviour({}, loop.robot);
  std::vector<double> at_m;
  bool down = false;
  (void)loop.run(behaviour, 100.0, [&](const Wish& wish) {
    const bool looks_down = wish.tilt_rad < loop.robot.resting_tilt_rad - 0.05;
    if (looks_down && !down && loop.world.pose().x_m > 2.0) at_m.push_back(loop.world.pose().x_m);
    down = looks_down;
  });
  ASSERT_GT(at_m.size(), 8U);
  for (std::size_t k = 1; k < at_m.size(); ++k) {
    EXPECT_NEAR(at_m[k] - at_m[k - 1], 0.68, 0.08) << "glance " << k;
  }
}

TEST(TraverseCorridor, ReturnsToTheFirstHeadingAfterABox) {
  flat::Layout layout = plain_corridor(12.0);
  flat::add_box(layout, {4.0, 0.1}, 0.5, 0.5, 0.0, 0.0, 0.8);
  flat::Loop loop(layout, 4);
  TraverseCorridor behaviour({}, loop.robot);
  const flat::RunResult result = loop.run(behaviour, 120.0);
  EXPECT_TRUE(result.reached) << tell(result);
  EXPECT_NEAR(result.end.heading_rad, 0.0, 0.12);
  EXPECT_NEAR(result.end.y_m, 0.0, 0.35);
}

TEST(TraverseCorridor, KeepsASide) {
  TraverseCorridor::Settings settings;
  settings.keep = TraverseCorridor::Keep::right;
  const flat::RunResult result = traverse(plain_corridor(15.0), 5, 120.0, settings);
  EXPECT_TRUE(result.reached) << tell(result);
  EXPECT_LT(result.end.y_m, -0.25);
  EXPECT_GT(result.end.y_m, -0.85);
}

TEST(TraverseCorridor, PassesAGapOfSeventyFiveCentimetres) {
  flat::Layout layout = plain_corridor(9.0);
  flat::add_box(layout, {5.0, 0.80}, 0.3, 0.80, 0.0, 0.0, 1.2);    // 0.40 .. 1.20
  flat::add_box(layout, {5.0, -0.775}, 0.3, 0.85, 0.0, 0.0, 1.2);  // -0.35 .. -1.20
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const flat::RunResult result = traverse(layout, seed, 120.0);
    EXPECT_TRUE(result.reached) << "seed " << seed << " " << tell(result);
  }
}

TEST(TraverseCorridor, FailsWithAReasonWhereTheCorridorIsShut) {
  flat::Layout layout = plain_corridor(20.0);
  flat::add_box(layout, {6.0, 0.0}, 0.4, 2.4, 0.0, 0.0, 1.2);
  const flat::RunResult result = traverse(layout, 6, 400.0);
  EXPECT_FALSE(result.touched);
  EXPECT_EQ(result.progress, Progress::failed);
  EXPECT_NE(result.why.find("no way through"), std::string::npos) << result.why;
  EXPECT_GT(result.end.x_m, 3.0);
}

// The search for a gap may leave the robot turned round; trying again is not the way back.
TEST(TraverseCorridor, TriedAgainAfterAFailureItKeepsItsDirection) {
  flat::Layout layout = plain_corridor(20.0);
  flat::add_box(layout, {6.0, 0.0}, 0.4, 2.4, 0.0, 0.0, 1.2);
  flat::Loop loop(layout, 6);
  TraverseCorridor behaviour({}, loop.robot);
  const flat::RunResult first = loop.run(behaviour, 400.0);
  ASSERT_EQ(first.progress, Progress::failed);
  TurnTo turn({.heading_rad = std::numbers::pi}, loop.robot);
  turn.start(loop.memory);
  for (int i = 0; i < 150; ++i) {
    if (loop.cycle(turn, "turn_to").progress != Progress::running) break;
  }
  ASSERT_GT(std::abs(loop.memory.pose().heading_rad), 2.0);
  behaviour.start(loop.memory);
  for (int i = 0; i < 200; ++i) loop.cycle(behaviour, "traverse_corridor");
  EXPECT_GT(loop.world.pose().x_m, first.end.x_m - 1.0);
  EXPECT_FALSE(loop.world.touched());
}

TEST(TraverseCorridor, BacksOutSoonWhereItIsHeldThoughItFindsAWay) {
  flat::Loop loop(plain_corridor(20.0), 9);
  TraverseCorridor behaviour({}, loop.robot);
  for (int i = 0; i < 60; ++i) loop.cycle(behaviour, "traverse_corridor");
  ASSERT_GT(loop.world.forward_m_s(), 0.2);
  loop.held = true;
  double backs_after_s = 0.0;
  for (int i = 1; i <= 100 && backs_after_s == 0.0; ++i) {
    if (loop.cycle(behaviour, "traverse_corridor").forward_m_s < 0.0) backs_after_s = 0.1 * i;
  }
  EXPECT_GT(backs_after_s, 2.0);
  EXPECT_LT(backs_after_s, 5.0);
}

TEST(TraverseCorridor, WaitsForSomeoneWhoShutsTheWayAndGoesOn) {
  flat::Layout layout = plain_corridor(9.0);
  flat::add_box(layout, {4.5, 0.8}, 0.4, 0.8, 0.0, 0.0, 1.2);
  flat::add_box(layout, {4.5, -0.8}, 0.4, 0.8, 0.0, 0.0, 1.2);
  flat::Person person;  // stands in the gap for eight seconds, then goes away through it
  person.path = {{8.0, 0.0}, {4.5, 0.0}, {8.0, -0.85}};
  person.starts_at_m = 8.0;
  person.pause_s = 8.0;
  layout.people.push_back(person);
  const flat::RunResult result = traverse(layout, 7, 200.0);
  EXPECT_TRUE(result.reached) << tell(result);
}

TEST(TraverseCorridor, CreepsOverFloorItCannotSeeInsteadOfFreezing) {
  flat::CameraErrors errors;
  errors.floor_seen = 0.0;
  flat::Loop loop(plain_corridor(5.0), 8, errors);
  TraverseCorridor behaviour({}, loop.robot);
  double fastest = 0.0;
  const flat::RunResult result = loop.run(behaviour, 120.0, [&](const Wish&) {
    fastest = std::max(fastest, loop.world.forward_m_s());
  });
  EXPECT_TRUE(result.reached) << tell(result);
  EXPECT_LT(fastest, 0.25);
}

TEST(TraverseCorridor, StandsWhenImagesStopComing) {
  flat::Loop loop(plain_corridor(20.0), 9);
  TraverseCorridor behaviour({}, loop.robot);
  for (int i = 0; i < 120; ++i) loop.cycle(behaviour, "traverse_corridor");
  ASSERT_GT(loop.world.forward_m_s(), 0.3);
  loop.camera_off = true;
  for (int i = 0; i < 12; ++i) loop.cycle(behaviour, "traverse_corridor");
  EXPECT_EQ(loop.limited.reason, LimitReason::image_old);
  EXPECT_NEAR(loop.world.forward_m_s(), 0.0, 1e-6);
}

TEST(TraverseCorridor, EndsAfterItsDistance) {
  TraverseCorridor::Settings settings;
  settings.distance_m = 6.0;
  const flat::RunResult result = traverse(plain_corridor(20.0), 10, 60.0, settings);
  EXPECT_EQ(result.progress, Progress::succeeded);
  EXPECT_NEAR(result.end.x_m, 6.0, 0.25);
}

TEST(TraverseCorridor, TheSameSeedGivesTheSameRun) {
  const flat::Layout layout = flat::random_corridor(77, 12.0);
  const flat::RunResult a = traverse(layout, 77);
  const flat::RunResult b = traverse(layout, 77);
  EXPECT_EQ(a.duration_s, b.duration_s);
  EXPECT_EQ(a.end.x_m, b.end.x_m);
  EXPECT_EQ(a.end.y_m, b.end.y_m);
  EXPECT_EQ(a.end.heading_rad, b.end.heading_rad);
}

TEST(Avoid, GoesRoundAndSucceedsWhenTheWayIsOpen) {
  flat::Layout layout = plain_corridor(20.0);
  flat::add_box(layout, {3.0, 0.0}, 0.5, 0.5, 0.0, 0.0, 0.8);
  flat::Loop loop(layout, 11);
  Avoid avoid({}, loop.robot);
  TraverseCorridor ahead({}, loop.robot);
  for (int i = 0; i < 40; ++i) loop.cycle(ahead, "traverse_corridor");
  avoid.start(loop.memory);
  Wish wish;
  for (int i = 0; i < 400 && wish.progress == Progress::running; ++i) {
    wish = loop.cycle(avoid, "avoid");
  }
  EXPECT_EQ(wish.progress, Progress::succeeded);
  EXPECT_FALSE(loop.world.touched());
}

}  // namespace
}  // namespace striate::behaviours
