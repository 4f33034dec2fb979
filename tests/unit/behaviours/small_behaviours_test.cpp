#include <gtest/gtest.h>

#include "striate/behaviours/back_up.hpp"
#include "striate/behaviours/drive_straight.hpp"
#include "striate/behaviours/look_around.hpp"
#include "striate/behaviours/look_at.hpp"
#include "striate/behaviours/navigation/behind.hpp"
#include "striate/behaviours/registry.hpp"
#include "striate/behaviours/say.hpp"
#include "striate/behaviours/stop.hpp"
#include "striate/behaviours/turn_to.hpp"
#include "striate/behaviours/wait.hpp"
#include "tests/reference/flat_run.hpp"
#include "tests/reference/looks.hpp"

namespace striate::behaviours {
namespace {

flat::Layout open_floor() {
  flat::Layout layout;
  layout.goal_x_m = 1e6;
  return layout;
}

TEST(TurnTo, TurnsByAnAngle) {
  flat::Loop loop(open_floor(), 1);
  TurnTo turn({.by_rad = radians(-120.0)}, loop.robot);
  EXPECT_EQ(loop.run(turn, 20.0).progress, Progress::succeeded);
  EXPECT_NEAR(loop.memory.pose().heading_rad, radians(-120.0), 0.06);
}

TEST(TurnTo, TurnsToTheCorridorsHeading) {
  flat::Loop loop(open_floor(), 1);
  TurnTo away({.by_rad = 1.0}, loop.robot);
  loop.run(away, 20.0);
  TurnTo back({.heading_rad = radians(180.0)}, loop.robot);
  back.start(loop.memory);
  for (int i = 0; i < 120; ++i) {
    if (loop.cycle(back, "turn_to").progress != Progress::running) break;
  }
  EXPECT_NEAR(std::abs(loop.memory.pose().heading_rad), radians(180.0), 0.06);
}

TEST(BackUp, DrivesBackAndKeepsItsHeading) {
  flat::Loop loop(open_floor(), 1);
  BackUp back({.distance_m = 0.5, .speed_m_s = 0.15}, loop.robot);
  EXPECT_EQ(loop.run(back, 20.0).progress, Progress::succeeded);
  EXPECT_NEAR(loop.world.pose().x_m, -0.5, 0.04);
  EXPECT_NEAR(loop.world.pose().y_m, 0.0, 0.02);
}

TEST(BackUp, WithKnownFloorStaysWhereNothingIsKnownBehind) {
  flat::Loop loop(open_floor(), 1);
  BackUp back({.distance_m = 0.5, .speed_m_s = 0.15, .known_floor = true}, loop.robot);
  const flat::RunResult result = loop.run(back, 20.0);
  EXPECT_EQ(result.progress, Progress::failed);
  EXPECT_EQ(result.why, "the floor behind is not known");
  EXPECT_NEAR(loop.world.pose().x_m, 0.0, 0.01);
}

TEST(BackUp, WithKnownFloorGoesBackWhereItCameFrom) {
  flat::Loop loop(open_floor(), 1);
  DriveStraight drive({.distance_m = 1.5, .speed_m_s = 0.4}, loop.robot);
  ASSERT_EQ(loop.run(drive, 30.0).progress, Progress::succeeded);
  const double from_m = loop.world.pose().x_m;
  BackUp back({.distance_m = 0.5, .speed_m_s = 0.15, .known_floor = true}, loop.robot);
  back.start(loop.memory);
  EXPECT_EQ(loop.run(back, 60.0).progress, Progress::succeeded);
  EXPECT_NEAR(loop.world.pose().x_m, from_m - 0.5, 0.04);
}

// Without images only the way that was driven is known.
TEST(FreeBehind, IsTheWayThatWasDrivenAndEndsWhereTheRobotTurnedFromIt) {
  const RobotDescription robot;
  memory::ShortTermMemory memory({}, robot);
  int ms = 0;
  for (double x_m = 0.0; x_m <= 0.6; x_m += 0.03) {
    memory.update(looks::senses_at(ms += 100, {x_m, 0.0, 0.0}), {});
  }
  EXPECT_NEAR(free_behind_m(memory, robot), 0.6, 0.06);
  for (double turned_rad = 0.0; turned_rad <= 1.6; turned_rad += 0.05) {
    memory.update(looks::senses_at(ms += 100, {0.6, 0.0, turned_rad}), {});
  }
  EXPECT_LE(free_behind_m(memory, robot), kRoomBehind_m);
}

TEST(DriveStraight, DrivesItsDistance) {
  flat::Loop loop(open_floor(), 1);
  DriveStraight drive({.distance_m = 2.0, .speed_m_s = 0.4}, loop.robot);
  const flat::RunResult result = loop.run(drive, 30.0);
  EXPECT_EQ(result.progress, Progress::succeeded);
  EXPECT_NEAR(loop.world.pose().x_m, 2.0, 0.08);
}

TEST(DriveStraight, FailsBeforeAWallAndDoesNotTouchIt) {
  flat::Layout layout = open_floor();
  layout.faces.push_back({{2.5, -2.0}, {2.5, 2.0}, 0.0, 2.7, false});
  flat::Loop loop(layout, 1);
  DriveStraight drive({.distance_m = 4.0, .speed_m_s = 0.4}, loop.robot);
  const flat::RunResult result = loop.run(drive, 60.0);
  EXPECT_EQ(result.progress, Progress::failed);
  EXPECT_FALSE(result.why.empty());
  EXPECT_FALSE(result.touched);
  EXPECT_GT(result.end.x_m, 1.5);
}

TEST(Wait, WaitsItsTime) {
  flat::Loop loop(open_floor(), 1);
  Wait wait({.for_s = 2.0}, loop.robot);
  const flat::RunResult result = loop.run(wait, 20.0);
  EXPECT_EQ(result.progress, Progress::succeeded);
  EXPECT_NEAR(result.duration_s, 2.2, 0.11);
  EXPECT_NEAR(result.end.x_m, 0.0, 1e-9);
}

TEST(Stop, SucceedsOnlyWhenTheRobotStands) {
  flat::Loop loop(open_floor(), 1);
  DriveStraight drive({.distance_m = 5.0, .speed_m_s = 0.4}, loop.robot);
  for (int i = 0; i < 40; ++i) loop.cycle(drive, "drive_straight");
  ASSERT_GT(loop.world.forward_m_s(), 0.3);
  Stop stop({}, loop.robot);
  EXPECT_EQ(loop.cycle(stop, "stop").progress, Progress::running);
  Wish wish;
  for (int i = 0; i < 20 && wish.progress == Progress::running; ++i)
    wish = loop.cycle(stop, "stop");
  EXPECT_EQ(wish.progress, Progress::succeeded);
  EXPECT_LT(loop.world.forward_m_s(), 0.01);
}

TEST(LookAt, TurnsTheHeadToADirectionAndLooksThereForItsTime) {
  flat::Loop loop(open_floor(), 1);
  LookAt look({.pan_rad = radians(40.0), .tilt_rad = -0.1, .for_s = 1.0}, loop.robot);
  double farthest_rad = 0.0;
  const flat::RunResult result = loop.run(look, 20.0, [&](const Wish&) {
    farthest_rad = std::max(farthest_rad, loop.world.head().pan_rad);
  });
  EXPECT_EQ(result.progress, Progress::succeeded);
  EXPECT_NEAR(farthest_rad, radians(40.0), 0.06);
  EXPECT_GT(result.duration_s, 1.2);
  EXPECT_NEAR(result.end.x_m, 0.0, 1e-9);
}

TEST(LookAt, FailsWhereNothingIsSalient) {
  flat::Loop loop(open_floor(), 1);
  LookAt look({.target = LookAt::Target::salient}, loop.robot);
  const flat::RunResult result = loop.run(look, 20.0);
  EXPECT_EQ(result.progress, Progress::failed);
  EXPECT_EQ(result.why, "nothing salient to look at");
}

TEST(LookAt, FollowsTheMostSalientRegionOfMemory) {
  const RobotDescription robot;
  memory::ShortTermMemory memory({}, robot);
  Senses senses;
  perception::Percept percept;
  LookAt look({.target = LookAt::Target::salient, .for_s = 0.5}, robot);
  Wish wish;
  for (int i = 1; i < 40; ++i) {
    senses.now = TimePoint(std::chrono::milliseconds(100 * i));
    senses.head.pan_rad = wish.pan_rad;
    percept.stamp = senses.now;
    percept.valid = true;
    percept.saliency.regions.resize(1);
    percept.saliency.regions[0].bearing_rad = radians(12.0);
    percept.saliency.regions[0].salience = 0.8;
    memory.update(senses, percept);
    if (i == 5) look.start(memory);
    if (i >= 5) wish = look.tick(memory);
    if (i == 8) {
      EXPECT_NEAR(wish.pan_rad, radians(12.0), 0.1);
    }
    if (wish.progress != Progress::running) break;
  }
  EXPECT_EQ(wish.progress, Progress::succeeded);
}

TEST(Say, ShowsItsTextForItsTimeAndThenSucceeds) {
  flat::Loop loop(open_floor(), 1);
  Say say({.text = "hello", .for_s = 1.0}, loop.robot);
  int shown = 0;
  const flat::RunResult result =
      loop.run(say, 20.0, [&](const Wish& wish) { shown += wish.why.view() == "says: hello"; });
  EXPECT_EQ(result.progress, Progress::succeeded);
  EXPECT_GE(shown, 9);
}

TEST(LookAround, SeesWhatStandsBesideTheView) {
  flat::Layout layout = open_floor();
  flat::add_box(layout, {1.3, 1.8}, 0.5, 0.5, 0.0, 0.0, 1.0);
  flat::Loop loop(layout, 1);
  const auto known = [&loop] {
    return loop.memory.map().state(memory::LocalGrid::cell_of({1.15, 1.52}));
  };
  LookAround look({.pan_rad = radians(60.0), .dwell_s = 0.7}, loop.robot);
  loop.cycle(look, "look_around");
  loop.cycle(look, "look_around");
  EXPECT_EQ(known(), memory::CellState::unknown);
  Wish wish;
  for (int i = 0; i < 300 && wish.progress == Progress::running; ++i) {
    wish = loop.cycle(look, "look_around");
  }
  EXPECT_EQ(wish.progress, Progress::succeeded);
  EXPECT_EQ(known(), memory::CellState::occupied);
  EXPECT_NEAR(loop.world.head().pan_rad, 0.0, 0.06);
  EXPECT_NEAR(loop.world.pose().x_m, 0.0, 1e-9);
}

config::Node map_of(const std::vector<std::pair<std::string, std::string>>& pairs) {
  config::Node node;
  node.kind = config::Node::Kind::map;
  for (const auto& [key, value] : pairs) {
    config::Node scalar;
    scalar.kind = config::Node::Kind::scalar;
    scalar.text = value;
    node.entries.push_back({key, {}, scalar});
  }
  return node;
}

TEST(BehaviourRegistry, HasEveryBehaviourWithHelpAndDefaults) {
  for (const char* name : {"traverse_corridor", "avoid", "look_around", "back_up", "turn_to",
                           "drive_straight", "wait", "stop"}) {
    const BehaviourEntry* entry = find_behaviour(name);
    ASSERT_NE(entry, nullptr) << name;
    EXPECT_FALSE(entry->help.empty());
    config::Diagnostics diagnostics("test");
    EXPECT_NE(entry->make({}, diagnostics, {}), nullptr);
    EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  }
  EXPECT_EQ(find_behaviour("fly"), nullptr);
}

TEST(BehaviourRegistry, ReadsArgumentsAndReportsWrongOnes) {
  config::Diagnostics diagnostics("test");
  const BehaviourEntry* entry = find_behaviour("traverse_corridor");
  entry->make(map_of({{"speed", "0.4 m/s"}, {"keep", "left"}}), diagnostics, {});
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  entry->make(map_of({{"sped", "0.4 m/s"}, {"keep", "up"}, {"speed", "4"}}), diagnostics, {});
  EXPECT_EQ(diagnostics.list().size(), 3U) << diagnostics.text();
}

TEST(BehaviourRegistry, ListsItsParameters) {
  const auto lines = find_behaviour("back_up")->parameters();
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].key, "distance");
  EXPECT_EQ(lines[0].value, "0.3 m");
}

}  // namespace
}  // namespace striate::behaviours
