#include <gtest/gtest.h>

#include <random>

#include "tests/unit/pioneer/standing.hpp"

/// Each test breaks one thing while the robot drives and measures, in the robot, the time until its
/// wheels are commanded to stand; then it mends the thing and looks whether motion comes back.
namespace striate::pioneer {
namespace {

TEST(SafetyGate, DrivesAsItIsToldWithinTheLimits) {
  TestBed bed;
  bed.drive();
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::none);
  bed.command = MotorCommand{.forward_m_s = 3.0, .turn_rad_s = 0.5};
  bed.run(2.0);
  EXPECT_NEAR(bed.firmware.forward_m_s(), 0.75, 1e-6);
  EXPECT_NEAR(bed.firmware.turn_rad_s(), 0.5, radians(0.5) + 1e-9) << "whole degrees a second";
}

TEST(SafetyGate, ADeadCommandSourceStandsAfterItsLease) {
  TestBed bed;
  bed.drive();
  bed.command.reset();
  const double took_s = until_commanded(bed);
  EXPECT_GT(took_s, 0.5 - 2 * kStep_s);
  EXPECT_LE(took_s, 0.5 + 2 * kStep_s);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::command_old);
  bed.run(0.3);
  bed.drive();
  EXPECT_FALSE(stands(bed)) << "a new command drives";
  bed.command.reset();
  expect_still(bed, 3.0);
}

TEST(SafetyGate, ACommandOlderThanItsLeaseNeverDrives) {
  TestBed bed;
  bed.run_until([&] { return bed.base().motors_on; });
  bed.run(1.0);
  const TimePoint end = bed.now + std::chrono::seconds(3);
  while (bed.now < end) {
    bed.driver.gate().command({.forward_m_s = 0.3}, bed.now - std::chrono::milliseconds(520));
    bed.step();
    ASSERT_TRUE(stands(bed));
  }
}

TEST(SafetyGate, ACommandThatIsNoNumberStandsStill) {
  TestBed bed;
  bed.drive();
  bed.command = MotorCommand{.forward_m_s = std::nan(""), .turn_rad_s = 0.2};
  EXPECT_LE(until_commanded(bed), 2 * kStep_s);
}

TEST(SafetyGate, ASilentRobotIsToldToStandAfter300ms) {
  TestBed bed;
  bed.drive();
  bed.run_until([&] { return bed.now - bed.base().stamp < kStep_s * std::chrono::seconds(1); });
  bed.robot_speaks = false;
  const double took_s = until_commanded(bed);
  EXPECT_GT(took_s, 0.25);
  EXPECT_LE(took_s, 0.3 + 2 * kStep_s);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::robot_silent);
  bed.command.reset();  // the last command was given while the robot was silent
  bed.run(0.2);
  bed.robot_speaks = true;
  expect_still(bed, 2.0);
}

TEST(SafetyGate, WhenTheRobotSpeaksAgainAStopComesBeforeNewMotion) {
  TestBed bed;
  bed.drive();
  bed.robot_speaks = false;
  bed.robot_hears = false;
  bed.run(1.0);
  EXPECT_GT(bed.firmware.forward_m_s(), 0.29) << "it never heard the stop";
  bed.robot_speaks = bed.robot_hears = true;
  bed.run_until([&] { return !bed.line.to_robot.empty() || bed.firmware.commanded_to_stand(); });
  EXPECT_TRUE(bed.firmware.commanded_to_stand());
}

TEST(SafetyGate, AfterALongGapTheOldMotionIsNotTakenUpAgain) {
  TestBed bed;
  bed.drive();
  bed.program_runs = false;  // as if it were suspended
  const double took_s = until_commanded(bed);
  EXPECT_GT(took_s, 2.0 - 0.11) << "the robot's own watchdog";
  EXPECT_LE(took_s, 2.0 + 2 * kStep_s);
  bed.run(2.0);
  bed.command.reset();
  bed.line.to_program.clear();
  bed.program_runs = true;
  double most_m_s = 0.0;
  for (int i = 0; i < 300; ++i) {
    bed.step();
    most_m_s = std::max(most_m_s, bed.firmware.forward_m_s());
  }
  EXPECT_EQ(most_m_s, 0.0) << "the first bytes after the gap are a stop";
}

TEST(Firmware, TakesTheOldMotionUpAgainIfNobodySaysStop) {
  TestBed bed;
  bed.drive();
  bed.program_runs = false;
  bed.run(4.0);
  ASSERT_TRUE(stands(bed));
  bed.firmware.receive(arcos::command(arcos::Command::pulse), bed.now);
  bed.run(1.0);
  EXPECT_GT(bed.firmware.forward_m_s(), 0.29) << "why the gate stops first";
}

TEST(SafetyGate, ACutLinkIsStoppedByTheRobotAndNeedsAReset) {
  TestBed bed;
  bed.drive();
  bed.line.unplug();
  const double took_s = until_commanded(bed);
  EXPECT_LE(took_s, 2.0 + 2 * kStep_s);
  bed.run(1.0);
  bed.line.plugged = true;
  bed.run_until([&] { return bed.driver.session().state() == LinkState::ready; }, 20.0);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::link_lost);
  expect_still(bed, 3.0);
  bed.driver.gate().reset(bed.now);
  bed.drive();
  EXPECT_FALSE(stands(bed));
}

TEST(SafetyGate, ARebootedRobotStandsUntilReset) {
  TestBed bed;
  bed.drive();
  bed.firmware.reboot();
  EXPECT_TRUE(stands(bed));
  bed.run_until([&] { return bed.driver.session().counters().connections == 2; });
  expect_still(bed, 3.0);
  bed.driver.gate().reset(bed.now);
  bed.drive();
  EXPECT_FALSE(stands(bed));
}

TEST(SafetyGate, AnEmergencyStopIsLatchedAndSwitchesTheMotorsOff) {
  TestBed bed;
  bed.drive();
  bed.driver.gate().emergency_stop(bed.now);
  EXPECT_LE(until_commanded(bed), 2 * kStep_s);
  EXPECT_LE(bed.run_until([&] { return stands(bed); }), 0.3) << "faster than a usual stop";
  expect_still(bed, 3.0);
  EXPECT_FALSE(bed.firmware.motors_on());
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::emergency);
  bed.driver.gate().reset(bed.now);
  bed.drive();
  EXPECT_TRUE(bed.firmware.motors_on());
  EXPECT_FALSE(stands(bed));
}

TEST(SafetyGate, TheRobotsOwnStopButtonIsLatchedWhenItIsReleased) {
  TestBed bed;
  bed.drive();
  bed.senses.stop_pressed = true;
  EXPECT_LE(until_commanded(bed), 2 * kStep_s);
  bed.run(1.0);
  bed.senses.stop_pressed = false;
  expect_still(bed, 3.0);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::emergency);
  bed.driver.gate().reset(bed.now);
  bed.drive();
  EXPECT_FALSE(stands(bed));
}

TEST(SafetyGate, MotorsThatGoOffAreNotSwitchedOnAgainByItself) {
  TestBed bed;
  bed.drive();
  bed.firmware.receive(arcos::command(arcos::Command::enable, 0), bed.now);
  bed.run(0.3);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::motors_off);
  expect_still(bed, 3.0);
  EXPECT_FALSE(bed.firmware.motors_on());
}

TEST(SafetyGate, TheJoystickTakesOverAndItsReleaseStopsTheRobot) {
  TestBed bed;
  bed.drive();
  bed.senses.joystick = {.button1 = true, .x = 512, .y = 256};
  bed.run(3.0);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::joystick);
  EXPECT_LT(bed.firmware.forward_m_s(), -0.15) << "the hand drives backwards";
  bed.senses.joystick = {};
  EXPECT_LE(until_commanded(bed), 0.2);
  expect_still(bed, 3.0);
  bed.driver.gate().reset(bed.now);
  bed.drive();
  EXPECT_FALSE(stands(bed));
}

TEST(SafetyGate, AJoystickThatMayNotDriveStopsTheRobotAllTheSame) {
  BaseDriverSettings settings;
  settings.session.joystick_may_drive = false;
  TestBed bed(settings);
  bed.drive();
  bed.senses.joystick = {.button1 = true, .x = 512, .y = 256};
  EXPECT_LE(until_commanded(bed), 0.2);
  expect_still(bed, 3.0);
}

TEST(SafetyGate, CountsOnNoMoreBrakeThanTheRobotWasTold) {
  const auto reason_half_a_metre_before = [](double acceleration_m_s2) {
    BaseDriverSettings settings;
    settings.session.acceleration_m_s2 = acceleration_m_s2;
    TestBed bed(settings);
    bed.drive();
    bed.front_m = 0.5;
    bed.run(0.5);
    return bed.driver.gate().reason();
  };
  EXPECT_EQ(reason_half_a_metre_before(0.3), HoldReason::none);
  EXPECT_EQ(reason_half_a_metre_before(0.05), HoldReason::slowed);
}

TEST(SafetyGate, SpeaksOfTheStopButtonOnceNotInEveryTick) {
  TestBed bed;
  bed.drive();
  std::size_t said = 0;
  bed.spoil = [&](Bytes& bytes) { said += bytes.size(); };
  bed.run(1.0);
  const std::size_t said_while_it_drove = said;
  bed.senses.stop_pressed = true;
  bed.run(0.3);
  said = 0;
  bed.run(1.0);
  EXPECT_LT(said, said_while_it_drove + 500U);
}

TEST(SafetyGate, AStormOfBadChecksumsIsSilence) {
  TestBed bed;
  bed.drive();
  std::mt19937 random(3);
  bed.spoil = [&](Bytes& bytes) {
    for (std::size_t i = 4; i < bytes.size(); i += 5) {
      bytes[i] ^= static_cast<std::uint8_t>(1 + random() % 255);
    }
  };
  EXPECT_LE(bed.run_until([&] { return bed.driver.gate().reason() == HoldReason::robot_silent; }),
            0.3 + 0.1 + 2 * kStep_s);
  EXPECT_GT(bed.driver.session().counters().stream.bad_checksum, 1u);
  // No stop gets through either: the robot's own watchdog.
  EXPECT_LE(until_commanded(bed), 2.0);
  bed.command.reset();
  bed.spoil = nullptr;
  expect_still(bed, 3.0);
}

TEST(SafetyGate, DrivesOnThroughSomeBadPackets) {
  TestBed bed;
  bed.drive();
  std::mt19937 random(5);
  bed.spoil = [&](Bytes& bytes) {
    if (!bytes.empty() && random() % 10 == 0) bytes[random() % bytes.size()] ^= 0x20;
  };
  bed.run(20.0);
  EXPECT_TRUE(bed.driver.session().state() == LinkState::ready);
  EXPECT_GT(bed.senses.true_pose.x_m, 4.0);
  EXPECT_NEAR(bed.base().odometry.pose.x_m, bed.senses.true_pose.x_m, 0.1)
      << "lost packets cost no way";
}

}  // namespace
}  // namespace striate::pioneer
