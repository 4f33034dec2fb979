#include "striate/behaviours/control/safety_limiter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/reference/looks.hpp"

namespace striate::behaviours {
namespace {

class Limiter : public testing::Test {
 protected:
  /// One cycle with fresh image and the same wish.
  MotorCommand cycle(double forward_m_s, double turn_rad_s,
                     const perception::Percept* shown = nullptr) {
    ms += 100;
    senses.now = looks::at_ms(ms);
    senses.odometry.stamp = senses.now;
    perception::Percept percept = shown != nullptr ? *shown : looks::blank_percept(ms);
    if (shown == nullptr) looks::see_floor(percept, 2.2, 5.0);
    percept.stamp = looks::at_ms(ms - image_age_ms);
    memory.update(senses, percept);
    Wish wish = standing_wish(memory, "test");
    wish.forward_m_s = forward_m_s;
    wish.turn_rad_s = turn_rad_s;
    wish.stamp = looks::at_ms(ms - wish_age_ms);
    const Limited limited = limiter.limit(wish, senses, memory);
    reason = limited.reason;
    held_by.assign(limited.held_by.begin(), limited.held_by.end());
    return limited.command;
  }
  MotorCommand settle(double forward_m_s, double turn_rad_s,
                      const perception::Percept* shown = nullptr) {
    MotorCommand command;
    for (int i = 0; i < 20; ++i) command = cycle(forward_m_s, turn_rad_s, shown);
    return command;
  }
  void echo(double bearing_rad, double distance_m) {
    senses.laser.readings = {{bearing_rad, distance_m}};
  }
  perception::Percept thing_at(double bearing_rad, double distance_m) {
    perception::Percept percept = looks::blank_percept(ms, bearing_rad);
    looks::see_thing(percept, bearing_rad, 0.15, distance_m);
    return percept;
  }

  RobotDescription robot;
  memory::ShortTermMemory memory{{}, robot};
  SafetyLimiterSettings settings;
  SafetyLimiter limiter{settings, robot};
  Senses senses;
  LimitReason reason = LimitReason::none;  ///< of the last cycle
  std::vector<Point2> held_by;             ///< of the last cycle
  int ms = 0;
  int image_age_ms = 100;
  int wish_age_ms = 0;
};

TEST_F(Limiter, LetsAWishThroughWhereNothingIsWrong) {
  const MotorCommand command = settle(0.4, 0.2);
  EXPECT_NEAR(command.forward_m_s, 0.4, 1e-9);
  EXPECT_NEAR(command.turn_rad_s, 0.2, 1e-9);
  EXPECT_EQ(reason, LimitReason::none);
}

TEST_F(Limiter, NeverAddsMotion) {
  for (double v = -0.7; v <= 0.7; v += 0.1) {
    for (double w = -1.0; w <= 1.0; w += 0.25) {
      echo(0.3, 0.1 + std::abs(v));
      const MotorCommand command = cycle(v, w);
      EXPECT_LE(std::abs(command.forward_m_s), std::abs(v) + 1e-9);
      EXPECT_LE(std::abs(command.turn_rad_s), std::abs(w) + 1e-9);
      EXPECT_GE(command.forward_m_s * v, -1e-9);
      EXPECT_GE(command.turn_rad_s * w, -1e-9);
    }
  }
}

TEST_F(Limiter, GathersSpeedNoFasterThanTheBodyMay) {
  EXPECT_NEAR(cycle(0.45, 0.0).forward_m_s, 0.05, 1e-9);
  EXPECT_EQ(reason, LimitReason::acceleration);
  EXPECT_NEAR(cycle(0.45, 0.0).forward_m_s, 0.10, 1e-9);
  settle(0.45, 0.0);
  EXPECT_EQ(cycle(0.0, 0.0).forward_m_s, 0.0);  // a stop is never delayed
}

TEST_F(Limiter, AnOldImageSlowsThenStops) {
  settle(0.4, 0.0);
  image_age_ms = 240;
  EXPECT_NEAR(settle(0.4, 0.0).forward_m_s, 0.4, 1e-9);
  image_age_ms = 400;
  const double slowed = settle(0.4, 0.0).forward_m_s;
  EXPECT_LT(slowed, 0.3);
  EXPECT_GT(slowed, 0.05);
  image_age_ms = 510;
  cycle(0.4, 0.5);
  const MotorCommand command = cycle(0.4, 0.5);
  EXPECT_EQ(command.forward_m_s, 0.0);
  EXPECT_EQ(command.turn_rad_s, 0.0);
  EXPECT_EQ(reason, LimitReason::image_old);
}

TEST_F(Limiter, StandsBeforeTheFirstImage) {
  Senses blind = looks::senses_at(100, {});
  memory.update(blind, perception::Percept{});
  Wish wish = standing_wish(memory, "test");
  wish.forward_m_s = 0.3;
  EXPECT_EQ(limiter.limit(wish, blind, memory).command.forward_m_s, 0.0);
}

TEST_F(Limiter, AnOldWishDoesNotDrive) {
  settle(0.4, 0.0);
  wish_age_ms = 200;
  EXPECT_NEAR(cycle(0.4, 0.0).forward_m_s, 0.4, 1e-9);
  wish_age_ms = 210;
  EXPECT_EQ(cycle(0.4, 0.0).forward_m_s, 0.0);
  EXPECT_EQ(reason, LimitReason::wish_old);
}

TEST_F(Limiter, SlowsInTheApproachZoneAndStopsBeforeAnEcho) {
  settle(0.45, 0.0);
  echo(0.0, 1.3);
  EXPECT_NEAR(cycle(0.45, 0.0).forward_m_s, 0.45, 1e-6);
  echo(0.0, 0.21 + 0.04 + 0.30);
  const double slowed = cycle(0.45, 0.0).forward_m_s;
  EXPECT_LT(slowed, 0.35);
  EXPECT_GT(slowed, 0.1);
  echo(0.0, 0.21 + 0.03);
  EXPECT_EQ(cycle(0.45, 0.0).forward_m_s, 0.0);
  EXPECT_EQ(reason, LimitReason::emergency_range);
}

// Each cycle sees the thing where it is by then: what little may be lost in one must not add up.
TEST_F(Limiter, DoesNotCreepUpToAnEcho) {
  for (const double forward_m_s : {0.02, 0.04, 0.10}) {
    for (const double turn_rad_s : {-0.04, 0.0, 0.04}) {
      Pose2 pose;
      // Ahead of the right front corner, and inside its lane by 3 cm.
      const Point2 thing{robot.front_m + 0.10, -robot.half_width_m + 0.03};
      limiter = SafetyLimiter(settings, robot);
      const Footprint footprint(robot);
      double nearest_m = 1.0;
      for (int k = 0; k < 600; ++k) {
        const Point2 seen = inverse_transform(pose, thing);
        echo(std::atan2(seen.y_m, seen.x_m), std::hypot(seen.x_m, seen.y_m));
        const MotorCommand command = cycle(forward_m_s, turn_rad_s);
        pose = along_arc(pose, command.forward_m_s, command.turn_rad_s, 0.1);
        nearest_m = std::min(nearest_m, footprint.distance_m(inverse_transform(pose, thing)));
      }
      EXPECT_GT(nearest_m, 0.005) << forward_m_s << " m/s, " << turn_rad_s << " rad/s";
    }
  }
}

TEST_F(Limiter, CountsEachTimeTheEmergencyLayerStepsInOnce) {
  settle(0.45, 0.0);
  for (int time = 1; time <= 3; ++time) {
    echo(0.0, 0.25);
    for (int i = 0; i < 5; ++i) cycle(0.3, 0.0);
    EXPECT_EQ(limiter.emergency_stops(), time);
    senses.laser.readings.clear();
    settle(0.3, 0.0);
  }
}

TEST_F(Limiter, WithTheEmergencyLayerOffEchoesDoNothing) {
  settings.emergency_layer = false;
  limiter = SafetyLimiter(settings, robot);
  echo(0.0, 0.25);
  EXPECT_NEAR(settle(0.4, 0.0).forward_m_s, 0.4, 1e-9);
  EXPECT_EQ(limiter.emergency_stops(), 0);
}

TEST_F(Limiter, WhatMemoryHoldsStopsTheRobotAlsoWithoutTheEmergencyLayer) {
  settings.emergency_layer = false;
  limiter = SafetyLimiter(settings, robot);
  const perception::Percept wall = thing_at(0.0, 0.30);
  EXPECT_LT(settle(0.4, 0.0, &wall).forward_m_s, 0.02);
  EXPECT_EQ(reason, LimitReason::memory_stop);
  EXPECT_EQ(limiter.emergency_stops(), 0);
}

TEST_F(Limiter, TheRobotMayAlwaysBackAwayAndTurnAway) {
  const perception::Percept wall = thing_at(0.0, 0.30);
  settle(0.0, 0.0, &wall);
  EXPECT_NEAR(settle(-0.2, 0.0, &wall).forward_m_s, -0.2, 1e-9);
}

TEST_F(Limiter, AThingAtACornerForbidsTurningTowardsItAndNotAway) {
  senses.laser.readings = {{radians(50.0), 0.38}};
  EXPECT_NEAR(settle(0.0, -0.6).turn_rad_s, -0.6, 1e-9);
  senses.laser.readings = {{radians(50.0), 0.33}};
  EXPECT_LT(settle(0.0, 0.6).turn_rad_s, 0.1);
}

TEST_F(Limiter, AThingBesideDoesNotStopDrivingPast) {
  echo(radians(90.0), 0.2125 + 0.12);
  EXPECT_NEAR(settle(0.3, 0.0).forward_m_s, 0.3, 1e-9);
}

TEST_F(Limiter, AGapThatLeavesRoomIsPassed) {
  // Two posts 0.75 m apart, half a metre ahead.
  senses.laser.readings = {{std::atan2(0.375, 0.5), std::hypot(0.375, 0.5)},
                           {std::atan2(-0.375, 0.5), std::hypot(0.375, 0.5)}};
  EXPECT_GT(settle(0.15, 0.0).forward_m_s, 0.14);
}

TEST_F(Limiter, ABumperForbidsOnlyTheWayThatTouched) {
  settle(0.3, 0.0);
  senses.bumper = true;
  EXPECT_EQ(cycle(0.3, 0.0).forward_m_s, 0.0);
  EXPECT_EQ(reason, LimitReason::bumper);
  EXPECT_EQ(limiter.emergency_stops(), 1);
  EXPECT_LT(settle(-0.1, 0.0).forward_m_s, -0.09);
}

TEST_F(Limiter, AStallIsNotPushedAgainst) {
  settle(0.3, 0.0);
  senses.motors_stalled = true;
  EXPECT_EQ(cycle(0.3, 0.0).forward_m_s, 0.0);
  EXPECT_EQ(reason, LimitReason::stalled);
  senses.motors_stalled = false;
  EXPECT_EQ(cycle(0.3, 0.0).forward_m_s, 0.0);  // not at once
  EXPECT_GT(settle(0.3, 0.0).forward_m_s, 0.2);
}

TEST_F(Limiter, ALowBatterySlowsAndAnEmptyOneStops) {
  senses.battery_v = 11.0;
  EXPECT_NEAR(settle(0.45, 0.0).forward_m_s, 0.2, 1e-6);
  senses.battery_v = 10.5;
  EXPECT_EQ(settle(0.45, 0.0).forward_m_s, 0.0);
  EXPECT_EQ(reason, LimitReason::battery_low);
}

TEST_F(Limiter, NonsenseIsNoMotion) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const MotorCommand command = settle(nan, std::numeric_limits<double>::infinity());
  EXPECT_EQ(command.forward_m_s, 0.0);
  EXPECT_EQ(command.turn_rad_s, 0.0);
}

TEST_F(Limiter, SaysWhatTheEmergencyLayerSteppedInFor) {
  settle(0.3, 0.0);
  EXPECT_TRUE(held_by.empty());
  senses.laser.readings = {{0.0, 0.27}, {0.9, 0.9}, {3.0, 0.4}};  // ahead, to the side, behind
  settle(0.3, 0.0);
  EXPECT_EQ(reason, LimitReason::emergency_range);
  ASSERT_EQ(held_by.size(), 1U);
  EXPECT_NEAR(held_by[0].x_m, 0.27, 1e-9);
  EXPECT_NEAR(held_by[0].y_m, 0.0, 1e-9);
  settle(-0.1, 0.0);
  EXPECT_TRUE(held_by.empty()) << "it may leave";
  settle(0.0, 0.0);
  EXPECT_TRUE(held_by.empty()) << "it does not want to move";
}

TEST_F(Limiter, WhatTheBumperTouchesIsAllAcrossTheEndThatLeads) {
  settle(0.2, 0.0);
  senses.bumper = true;
  cycle(0.2, 0.0);
  EXPECT_EQ(reason, LimitReason::bumper);
  ASSERT_GT(held_by.size(), 4U);
  for (const Point2& place : held_by) {
    EXPECT_GT(place.x_m, robot.front_m);
    EXPECT_LE(std::abs(place.y_m), robot.half_width_m + 1e-9);
  }
}

}  // namespace
}  // namespace striate::behaviours
