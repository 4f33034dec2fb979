#include <gtest/gtest.h>

#include "tests/unit/pioneer/standing.hpp"

/// What the gate does by echoes, stalls, bumpers, the laser and the battery.
namespace striate::pioneer {
namespace {

TEST(SafetyGate, AnEchoInFrontSlowsAndStops) {
  TestBed bed;
  bed.drive();
  bed.front_m = 0.15;
  bed.run(1.0);
  EXPECT_LT(bed.firmware.forward_m_s(), 0.2);
  bed.front_m = 0.09;
  bed.run(1.0);
  EXPECT_TRUE(stands(bed));
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::obstacle);
  bed.command = MotorCommand{.forward_m_s = -0.2};
  bed.run(1.0);
  EXPECT_LT(bed.firmware.forward_m_s(), -0.19) << "away from it is free";
}

TEST(SafetyGate, AStallOrABumperEndsThePush) {
  TestBed bed;
  bed.drive();
  bed.senses.stalled = true;
  EXPECT_LE(until_commanded(bed), 0.1 + 2 * kStep_s);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::stalled);
  bed.senses.stalled = false;
  bed.run(2.0);
  bed.drive();
  bed.senses.bumper_front = true;
  EXPECT_LE(until_commanded(bed), 0.1 + 2 * kStep_s);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::bumper);
  bed.command = MotorCommand{.forward_m_s = -0.2};
  bed.run(1.0);
  EXPECT_LT(bed.firmware.forward_m_s(), -0.19);
}

TEST(SafetyGate, ALaserThatFallsSilentStopsTheRobot) {
  TestBed bed;
  bed.drive();
  ASSERT_EQ(bed.base().laser.readings.size(), 181u);
  bed.laser_speaks = false;
  const double took_s = until_commanded(bed);
  EXPECT_GT(took_s, 0.35);
  EXPECT_LE(took_s, 0.5 + 2 * kStep_s);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::laser_stale);
  expect_still(bed, 2.0);
}

TEST(SafetyGate, AnEmptyBatteryStands) {
  TestBed bed;
  bed.drive();
  bed.senses.battery_v = 10.5;
  EXPECT_LE(until_commanded(bed), 0.1 + 2 * kStep_s);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::battery_low);
}

}  // namespace
}  // namespace striate::pioneer
