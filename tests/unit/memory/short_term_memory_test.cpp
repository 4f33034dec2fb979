#include "striate/memory/short_term/short_term_memory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/reference/looks.hpp"

namespace striate::memory {
namespace {

using looks::senses_at;

CellState at(const ShortTermMemory& memory, double x_m, double y_m) {
  return memory.map().state(LocalGrid::cell_of({x_m, y_m}));
}

class ShortTermMemoryTest : public testing::Test {
 protected:
  /// `looks` images of a thing straight ahead at 2 m with floor before it.
  void see_box(int looks_count) {
    for (int i = 0; i < looks_count; ++i) {
      ms += 100;
      perception::Percept percept = looks::blank_percept(ms);
      looks::see_floor(percept, 0.9, 4.5);
      looks::see_thing(percept, 0.0, 0.1, 2.0);
      memory.update(senses_at(ms, pose), percept);
    }
  }
  void idle(int cycles) {
    for (int i = 0; i < cycles; ++i)
      memory.update(senses_at(ms += 100, pose), perception::Percept{});
  }
  RobotDescription robot;
  ShortTermMemory memory{{}, robot};
  Pose2 pose;
  int ms = 0;
};

TEST_F(ShortTermMemoryTest, AThingStaysWhereItIsWhileTheRobotTurnsRoundAndDrivesPast) {
  see_box(8);
  ASSERT_EQ(at(memory, 2.0, 0.0), CellState::occupied);
  for (int i = 0; i < 90; ++i) {
    pose.heading_rad = wrap_angle(pose.heading_rad + radians(4.0));
    idle(1);
  }
  for (int i = 0; i < 40; ++i) {
    pose.x_m += 0.045;
    pose.y_m = 0.8;
    idle(1);
  }
  EXPECT_EQ(at(memory, 2.0, 0.0), CellState::occupied);
  EXPECT_NE(at(memory, 2.0, 0.5), CellState::occupied);
  // It is now to the right of the robot, out of the camera's view: still known.
  const PolarMap map = memory.polar_map();
  const double bearing = std::atan2(0.0 - pose.y_m, 2.0 - pose.x_m);
  const double distance = std::hypot(2.0 - pose.x_m, pose.y_m);
  EXPECT_EQ(map.at(PolarMap::sector_of(bearing), PolarMap::ring_of(distance)).state,
            CellState::occupied);
}

TEST_F(ShortTermMemoryTest, AnImageBelongsToThePoseOfItsStamp) {
  // The robot turns at 0.5 rad/s; the image of t = 500 ms arrives at 800 ms.
  for (ms = 100; ms <= 800; ms += 100) {
    pose.heading_rad = 0.0005 * ms;
    perception::Percept percept;
    if (ms >= 400) {
      percept = looks::blank_percept(ms - 300);
      looks::see_thing(percept, -0.0005 * (ms - 300), 0.05, 2.0);  // straight along x
    }
    memory.update(senses_at(ms, pose), percept);
  }
  EXPECT_EQ(at(memory, 2.0, 0.0), CellState::occupied);
  EXPECT_EQ(at(memory, 2.0 * std::cos(0.25), 2.0 * std::sin(0.25)), CellState::unknown);
}

TEST_F(ShortTermMemoryTest, AnImageIsUsedOnce) {
  perception::Percept percept = looks::blank_percept(100);
  looks::see_thing(percept, 0.0, 0.1, 3.0);
  for (int i = 1; i <= 10; ++i) memory.update(senses_at(100 * i, {}), percept);
  EXPECT_NE(at(memory, 3.0, 0.0), CellState::occupied);
  EXPECT_NEAR(memory.image_age_s(), 0.9, 1e-9);
}

TEST_F(ShortTermMemoryTest, TheImageIsInfinitelyOldBeforeTheFirst) {
  EXPECT_TRUE(std::isinf(memory.image_age_s()));
  idle(3);
  EXPECT_TRUE(std::isinf(memory.image_age_s()));
}

TEST_F(ShortTermMemoryTest, FreeFloorFadesToUnknownAndStillThingsLast) {
  see_box(8);
  ASSERT_EQ(at(memory, 1.5, 0.0), CellState::free);
  idle(700);
  EXPECT_EQ(at(memory, 1.5, 0.0), CellState::unknown);
  EXPECT_EQ(at(memory, 2.0, 0.0), CellState::occupied);
}

TEST_F(ShortTermMemoryTest, APersonOutOfViewIsForgottenInSeconds) {
  for (int i = 0; i < 6; ++i) {
    perception::Percept empty = looks::blank_percept(ms += 100);
    looks::see_floor(empty, 0.9, 4.5);
    memory.update(senses_at(ms, pose), empty);
  }
  see_box(4);  // somebody stepped in
  ASSERT_EQ(at(memory, 2.0, 0.0), CellState::occupied);
  idle(100);
  EXPECT_NE(at(memory, 2.0, 0.0), CellState::occupied);
}

TEST_F(ShortTermMemoryTest, WhatStoppedTheRobotUnseenIsHeldAgainstTheEyesForHalfAMinute) {
  const auto see_floor_only = [this](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      perception::Percept floor = looks::blank_percept(ms += 100);
      looks::see_floor(floor, 0.3, 4.5);
      memory.update(senses_at(ms, pose), floor);
    }
  };
  see_floor_only(10);
  const std::array<Point2, 1> echo{Point2{0.6, 0.1}};
  memory.remember({}, "traverse_corridor", echo);
  see_floor_only(290);
  EXPECT_EQ(at(memory, 0.6, 0.1), CellState::occupied);
  EXPECT_TRUE(memory.map().stands(LocalGrid::cell_of({0.6, 0.1})));
  see_floor_only(20);
  EXPECT_EQ(at(memory, 0.6, 0.1), CellState::free) << "then the eyes are believed again";
}

TEST_F(ShortTermMemoryTest, WhatStoppedTheRobotStaysWhereItIsAndIsNotWhereTheRobotStands) {
  idle(1);
  pose = {1.0, 0.5, 0.5 * 3.14159265};
  idle(1);
  const std::array<Point2, 1> echo{Point2{0.4, 0.0}};
  memory.remember({}, "traverse_corridor", echo);
  pose = {0.2, 0.0, 0.0};
  idle(5);
  EXPECT_EQ(at(memory, 1.0, 0.9), CellState::occupied);
  pose = {1.0, 0.9, 0.0};
  idle(1);
  pose = {2.0, 0.9, 0.0};
  idle(1);
  EXPECT_EQ(at(memory, 1.0, 0.9), CellState::free) << "the robot has stood there";
}

TEST_F(ShortTermMemoryTest, SomebodyWhoWasSeenToComeIsNotHeldOnToWhenTheyStopTheRobot) {
  for (int i = 0; i < 6; ++i) {
    perception::Percept empty = looks::blank_percept(ms += 100);
    looks::see_floor(empty, 0.9, 4.5);
    memory.update(senses_at(ms, pose), empty);
  }
  see_box(4);  // somebody stepped in
  const std::array<Point2, 1> echo{Point2{2.0, 0.0}};
  memory.remember({}, "traverse_corridor", echo);
  idle(100);
  EXPECT_NE(at(memory, 2.0, 0.0), CellState::occupied);
}

TEST_F(ShortTermMemoryTest, WhereTheRobotStandsIsFree) {
  idle(1);
  EXPECT_EQ(at(memory, 0.0, 0.0), CellState::free);
  EXPECT_EQ(at(memory, -0.25, 0.15), CellState::free);
  EXPECT_EQ(at(memory, 0.5, 0.0), CellState::unknown);
}

TEST_F(ShortTermMemoryTest, CountsWayAndProgressAlongTheCorridor) {
  pose.heading_rad = 1.0;
  idle(1);
  for (int i = 0; i < 50; ++i) {
    pose = transform(pose, Pose2{0.04, 0.0, i < 25 ? 0.02 : -0.02});
    idle(1);
  }
  EXPECT_NEAR(memory.distance_travelled_m(), 2.0, 1e-6);
  EXPECT_LT(memory.progress_m(), 2.0);
  EXPECT_GT(memory.progress_m(), 1.9);
}

TEST_F(ShortTermMemoryTest, RemembersTheLastCommandsAndWhoWantedThem) {
  for (int i = 0; i < 40; ++i) {
    idle(1);
    memory.remember({0.01 * i, 0.0, 0.0, 0.0}, i < 39 ? "traverse_corridor" : "stop");
  }
  EXPECT_EQ(memory.doing(), "stop");
  EXPECT_NEAR(memory.sent().command.forward_m_s, 0.39, 1e-9);
  EXPECT_NEAR(memory.sent(3).command.forward_m_s, 0.36, 1e-9);
  EXPECT_EQ(memory.sent(1).doing.view(), "traverse_corridor");
}

TEST_F(ShortTermMemoryTest, TheSameInputGivesTheSameMap) {
  ShortTermMemory other({}, robot);
  for (int i = 0; i < 30; ++i) {
    const int t = 100 * (i + 1);
    perception::Percept percept = looks::blank_percept(t);
    looks::see_floor(percept, 0.9, 4.0 + 0.01 * i);
    looks::see_thing(percept, 0.01 * i, 0.05, 2.0 + 0.05 * i);
    const Senses senses = senses_at(t, {0.03 * i, 0.0, 0.002 * i});
    memory.update(senses, percept);
    other.update(senses, percept);
  }
  for (int y = -100; y < 100; ++y) {
    for (int x = -100; x < 100; ++x) {
      ASSERT_EQ(memory.map().log_odds({x, y}), other.map().log_odds({x, y}));
    }
  }
}

}  // namespace
}  // namespace striate::memory
