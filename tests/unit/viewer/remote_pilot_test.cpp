#include "striate/viewer/foxglove/remote_pilot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "striate/base/limits.hpp"
#include "tests/unit/viewer/hand_clock.hpp"

/// Who drives from a viewer, and for how long.
namespace striate::viewer::foxglove {
namespace {

TEST(RemotePilot, ACommandDrivesForItsLeaseOnBothClocksFromWhenItWasSent) {
  HandClock clock;
  RemotePilot pilot(clock, 0.0);
  const TimePoint sent = clock.time;
  clock.time += std::chrono::milliseconds(200);
  EXPECT_EQ(pilot.command(1, {0.3, 0.0}, sent), RemotePilot::Taken::taken);
  EXPECT_TRUE(pilot.wish(mission_ms(0)));
  clock.time = sent + kCommandLease;
  EXPECT_TRUE(pilot.wish(mission_ms(100)));
  clock.time += std::chrono::milliseconds(1);
  EXPECT_FALSE(pilot.wish(mission_ms(100)));
  // What has waited on the line since then does not drive.
  EXPECT_EQ(pilot.command(1, {0.3, 0.0}, sent), RemotePilot::Taken::too_old);
  EXPECT_FALSE(pilot.wish(mission_ms(100)));
  // A simulated mission may be faster than the clock on the wall.
  EXPECT_EQ(pilot.command(1, {0.3, 0.0}, clock.time), RemotePilot::Taken::taken);
  EXPECT_TRUE(pilot.wish(mission_ms(1000)));
  EXPECT_TRUE(pilot.wish(mission_ms(1500)));
  EXPECT_FALSE(pilot.wish(mission_ms(1501)));
}

TEST(RemotePilot, OneClientDrivesAndLeavesTheWheelWhenItIsGone) {
  HandClock clock;
  RemotePilot pilot(clock, 0.0);
  EXPECT_EQ(pilot.command(1, {0.3, 0.0}, clock.time), RemotePilot::Taken::taken);
  EXPECT_EQ(pilot.command(2, {-0.3, 0.0}, clock.time), RemotePilot::Taken::another_drives);
  EXPECT_EQ(pilot.wish(mission_ms(0))->forward_m_s, 0.3);
  pilot.leave(2);
  EXPECT_TRUE(pilot.wish(mission_ms(0)));
  pilot.leave(1);
  EXPECT_FALSE(pilot.wish(mission_ms(0)));
  EXPECT_EQ(pilot.command(2, {-0.3, 0.0}, clock.time), RemotePilot::Taken::taken);
}

TEST(RemotePilot, WhatIsNoNumberStandsAndSoDoesAPause) {
  HandClock clock;
  RemotePilot pilot(clock, -0.2);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    pilot.command(1, {bad, 0.5}, clock.time);
    EXPECT_EQ(pilot.wish(mission_ms(0))->forward_m_s, 0.0);
    EXPECT_EQ(pilot.wish(mission_ms(0))->turn_rad_s, 0.0);
  }
  pilot.command(1, {0.3, 0.0}, clock.time);
  pilot.pause();
  EXPECT_EQ(pilot.wish(mission_ms(0))->forward_m_s, 0.0);
  EXPECT_EQ(pilot.wish(mission_ms(0))->tilt_rad, -0.2);
  EXPECT_EQ(pilot.command(1, {0.3, 0.0}, clock.time), RemotePilot::Taken::paused);
  pilot.resume();
  EXPECT_FALSE(pilot.wish(mission_ms(0)));
}

// --- what waits for a client

}  // namespace
}  // namespace striate::viewer::foxglove
