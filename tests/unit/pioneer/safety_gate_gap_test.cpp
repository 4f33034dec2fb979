#include <gtest/gtest.h>

#include <deque>

#include "tests/unit/pioneer/standing.hpp"

/// Nothing resumes by itself after the program did not run, and nothing drives that is too old
/// where it is used: what the line takes counts.
namespace striate::pioneer {
namespace {

using namespace std::chrono_literals;

TEST(SafetyGate, AProgramThatWasStoppedHoldsUntilReset) {
  for (const double stopped_s : {0.6, 1.0, 3.0, 30.0}) {
    SCOPED_TRACE(stopped_s);
    TestBed bed;
    bed.drive();
    bed.program_runs = false;
    bed.run(stopped_s);
    bed.program_runs = true;  // and gives new commands at once
    bed.run(0.1);
    EXPECT_TRUE(bed.firmware.commanded_to_stand());
    expect_still(bed, 3.0);
    EXPECT_EQ(bed.driver.gate().reason(), HoldReason::stopped);
    EXPECT_TRUE(bed.driver.gate().latched());
    bed.driver.gate().reset(bed.now);
    bed.drive();
    EXPECT_FALSE(stands(bed));
  }
}

TEST(SafetyGate, AProgramThatMissedALittleGoesOn) {
  TestBed bed;
  bed.drive();
  bed.program_runs = false;
  bed.run(0.35);
  bed.program_runs = true;
  bed.run(0.1);
  bed.drive();
  EXPECT_FALSE(stands(bed));
}

TEST(SafetyGate, ACommandSourceThatHangsInTheMidstOfMotionHoldsUntilReset) {
  TestBed bed;
  bed.drive();
  bed.command.reset();
  bed.run(1.2);
  bed.command = MotorCommand{.forward_m_s = 0.3};
  expect_still(bed, 2.0);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::stopped);
  bed.driver.gate().reset(bed.now);
  bed.drive();
  EXPECT_FALSE(stands(bed));
}

TEST(SafetyGate, ACommandSourceThatLetTheRobotStandMayPause) {
  TestBed bed;
  bed.drive();
  bed.command = MotorCommand{};
  bed.run(1.0);
  bed.command.reset();
  bed.run(20.0);
  bed.drive();
  EXPECT_FALSE(stands(bed));
}

/// A line on which bytes take their time.
class Late {
 public:
  explicit Late(Duration& takes, TestBed& bed) : takes_(takes), bed_(bed) {}
  void operator()(Bytes& bytes) {
    if (!bytes.empty()) under_way_.emplace_back(bed_.now + takes_, std::exchange(bytes, {}));
    while (!under_way_.empty() && under_way_.front().first <= bed_.now) {
      append(bytes, under_way_.front().second);
      under_way_.pop_front();
    }
  }

 private:
  Duration& takes_;
  TestBed& bed_;
  std::deque<std::pair<TimePoint, Bytes>> under_way_;
};

/// A test bed whose line may be late: each way of its own.
struct LateBed {
  LateBed() : to_robot(there, bed), to_program(back, bed) {
    // TestBed spoils what goes to the robot first, then what comes from it.
    bed.spoil = [this](Bytes& bytes) {
      from_robot ? to_program(bytes) : to_robot(bytes);
      from_robot = !from_robot;
    };
  }
  TestBed bed;
  Duration there{};
  Duration back{};
  Late to_robot;
  Late to_program;
  bool from_robot = false;
};

TEST(SafetyGate, ALineThatGetsLateEitherWayMakesTheRobotStand) {
  for (const bool there : {true, false}) {
    for (const Duration late : {Duration(600ms), Duration(800ms), Duration(1500ms)}) {
      SCOPED_TRACE(testing::Message() << there << " " << to_seconds(late));
      LateBed late_bed;
      TestBed& bed = late_bed.bed;
      bed.drive();
      ASSERT_EQ(bed.driver.gate().reason(), HoldReason::none);
      (there ? late_bed.there : late_bed.back) = late;
      // Half a second to notice; a stop to the robot then takes its time itself.
      const double most_s = 0.9 + (there ? to_seconds(late) : 0.0);
      EXPECT_LE(until_commanded(bed), most_s);
      bed.run(there ? to_seconds(late) + 1.0 : 1.0);
      expect_still(bed, 5.0);
    }
  }
}

TEST(SafetyGate, ALineThatIsLateFromTheBeginningNeverDrives) {
  for (const bool there : {true, false}) {
    for (const Duration late : {Duration(800ms), Duration(2s), Duration(3s)}) {
      SCOPED_TRACE(testing::Message() << there << " " << to_seconds(late));
      LateBed late_bed;
      (there ? late_bed.there : late_bed.back) = late;
      TestBed& bed = late_bed.bed;
      bed.command = MotorCommand{.forward_m_s = 0.3};
      double most_m_s = 0.0;
      for (int i = 0; i < 4000; ++i) {
        bed.step();
        most_m_s = std::max(most_m_s, bed.firmware.forward_m_s());
      }
      EXPECT_EQ(most_m_s, 0.0);
    }
  }
}

TEST(SafetyGate, ALineThatIsFreshAgainDrivesAgain) {
  LateBed late_bed;
  TestBed& bed = late_bed.bed;
  bed.drive();
  late_bed.back = 800ms;
  bed.run(3.0);
  EXPECT_TRUE(stands(bed));
  late_bed.back = 0ms;
  bed.run(4.0);
  EXPECT_FALSE(stands(bed));
}

TEST(SafetyGate, WhatTheCommandWasDecidedByMustBeYoungAtTheWheels) {
  const auto drives = [](Duration seen_before, Duration line) {
    LateBed late_bed;
    late_bed.back = line;
    TestBed& bed = late_bed.bed;
    bed.run_until([&] { return bed.base().motors_on; });
    bed.run(1.0);
    for (int i = 0; i < 200; ++i) {
      bed.driver.gate().command({.forward_m_s = 0.3}, bed.now, bed.now - seen_before);
      bed.step();
    }
    return !bed.firmware.commanded_to_stand();
  };
  EXPECT_TRUE(drives(300ms, 0ms));
  EXPECT_FALSE(drives(520ms, 0ms));
  EXPECT_TRUE(drives(100ms, 150ms));
  EXPECT_FALSE(drives(300ms, 250ms)) << "what the line takes counts";
}

TEST(SafetyGate, ARobotThatAnswersNoQuestionsIsDrivenOnlyWhereThatIsAllowed) {
  for (const bool echo : {true, false}) {
    BaseDriverSettings settings;
    settings.session.echo = echo;
    TestBed bed(settings);
    // The answers to ENCODER, JOYINFO, IOREQUEST and CONFIG have these ids.
    bed.spoil = [](Bytes& bytes) {
      const bool answer = bytes.size() > 3 && (bytes[3] == 0x90 || bytes[3] == 0xf8 ||
                                               bytes[3] == 0xf0 || bytes[3] == 0x20);
      if (answer) bytes.clear();
    };
    bed.command = MotorCommand{.forward_m_s = 0.3};
    bed.run(6.0);
    EXPECT_EQ(stands(bed), echo);
    EXPECT_EQ(bed.driver.gate().reason(), echo ? HoldReason::line_late : HoldReason::none);
  }
}

}  // namespace
}  // namespace striate::pioneer
