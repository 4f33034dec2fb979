#include "striate/platform/pioneer/keeper/line_keeper.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/pioneer/test_bed.hpp"

namespace striate::pioneer {
namespace {

using namespace std::chrono_literals;
using arcos::Command;
using arcos::command;

/// A mind, the keeper and the firmware's model, in steps of 10 ms of virtual time.
class KeptBed {
 public:
  static constexpr Duration kStep = 10ms;

  void step() {
    now += kStep;
    if (mind_lives && mind_runs) {
      driver.gate().command({.forward_m_s = wanted_m_s}, now);
      driver.step(now);
      keeper.from_mind(std::exchange(line.to_robot, {}), now);
    }
    keeper.tick(now);
    const ByteView out = keeper.to_robot().first(std::min(keeper.to_robot().size(), line_takes));
    firmware.receive(out, now);
    append(heard, out);
    keeper.sent(out.size());
    senses.odometry.forward_m_s = firmware.forward_m_s();
    way_m += firmware.forward_m_s() * to_seconds(kStep);
    firmware.step(now, kStep, senses);
    const Bytes answer = firmware.take_output();
    keeper.from_robot(answer, now);
    if (mind_lives && line.is_open()) append(line.to_program, answer);
  }
  void run(double seconds) {
    for (const TimePoint end = now + from_seconds(seconds); now < end;) step();
  }
  void die() {
    mind_lives = false;
    keeper.mind_has_died(now);
  }
  /// Drives until it is as fast as it is to be.
  void drive_at(double m_s) {
    wanted_m_s = m_s;
    for (int i = 0; i < 1000 && std::abs(firmware.forward_m_s() - m_s) > 0.001; ++i) step();
    ASSERT_NEAR(firmware.forward_m_s(), m_s, 0.001);
    way_m = 0.0;
    heard.clear();
  }
  double seconds_until_told_to_stand(double limit_s = 3.0) {
    const TimePoint begin = now;
    while (!firmware.commanded_to_stand() && to_seconds(now - begin) < limit_s) step();
    return to_seconds(now - begin);
  }

  BaseDriverSettings settings;
  MemoryLine line;
  BaseDriver driver{settings, line};
  LineKeeper keeper;
  ArcosFirmware firmware{FirmwareSettings{}};
  FirmwareSenses senses;
  TimePoint now = TimePoint(1s);
  bool mind_lives = true;
  bool mind_runs = true;
  double wanted_m_s = 0.0;
  double way_m = 0.0;
  Bytes heard;  ///< by the robot
  std::size_t line_takes = 100000;
};

double braking_m(double v_m_s) {
  return v_m_s * v_m_s / (2.0 * SessionSettings{}.acceleration_m_s2);
}

TEST(LineKeeper, StopsTheRobotAtOnceWhenTheMindDiesAndClosesItsSession) {
  KeptBed bed;
  bed.drive_at(0.65);
  bed.die();
  EXPECT_LE(bed.seconds_until_told_to_stand(), 0.02);
  bed.run(5.0);
  EXPECT_EQ(bed.firmware.forward_m_s(), 0.0);
  EXPECT_LT(bed.way_m, braking_m(0.65) + 0.05);
  EXPECT_FALSE(bed.firmware.motors_on());
  EXPECT_FALSE(bed.firmware.connected());
  EXPECT_TRUE(bed.keeper.done());
}

TEST(LineKeeper, SwitchesTheMotorsOffOnlyWhenTheRobotStands) {
  KeptBed bed;
  bed.drive_at(0.65);
  bed.die();
  while (bed.firmware.motors_on() && bed.now < TimePoint(60s)) {
    bed.step();
    if (!bed.firmware.motors_on()) {
      EXPECT_LT(bed.firmware.forward_m_s(), 0.01);
    }
  }
  EXPECT_FALSE(bed.firmware.motors_on());
}

TEST(LineKeeper, StopsTheRobotOfAMindThatIsSilentAndLetsItDriveOnWhenItSpeaksAgain) {
  KeptBed bed;
  bed.drive_at(0.65);
  bed.mind_runs = false;
  EXPECT_LT(bed.seconds_until_told_to_stand(), 0.3);
  bed.run(0.3);
  EXPECT_TRUE(bed.firmware.commanded_to_stand());
  EXPECT_TRUE(bed.firmware.connected());
  bed.mind_runs = true;
  bed.run(1.0);
  EXPECT_FALSE(bed.firmware.commanded_to_stand());
  EXPECT_FALSE(bed.keeper.mind_is_shut_out());
}

TEST(LineKeeper, ClosesTheSessionOfAMindThatStaysSilent) {
  KeptBed bed;
  bed.drive_at(0.65);
  bed.mind_runs = false;
  bed.run(35.0);
  EXPECT_TRUE(bed.firmware.connected()) << "somebody may have stopped it, and lets it go on";
  EXPECT_TRUE(bed.firmware.commanded_to_stand());
  bed.run(570.0);
  EXPECT_TRUE(bed.keeper.mind_is_shut_out());
  EXPECT_TRUE(bed.keeper.done());
  EXPECT_FALSE(bed.firmware.connected());
  EXPECT_FALSE(bed.firmware.motors_on());
}

TEST(LineKeeper, AStandingRobotNeedsNoWordFromTheMind) {
  KeptBed bed;
  bed.drive_at(0.65);
  bed.drive_at(0.0);
  bed.run(1.0);
  bed.heard.clear();
  bed.mind_runs = false;
  bed.run(1.0);
  EXPECT_TRUE(bed.heard.empty());
}

TEST(LineKeeper, ChangesNoByteOfAMindThatLives) {
  KeptBed bed;
  bed.drive_at(0.3);
  Bytes said;
  Bytes came;
  for (const int forward : {100, -200, 300}) {
    append(said, command(Command::velocity, forward));
    append(said, Bytes{0x57, 0x4d, 0xfa, 0xfa, 0x01});  // junk, and a beginning that is none
    append(said, command(Command::polling, std::string("\x01\x02")));
  }
  for (std::size_t at = 0; at < said.size(); ++at) {
    bed.keeper.from_mind(ByteView(said).subspan(at, 1), bed.now);
    append(came, bed.keeper.to_robot());
    bed.keeper.sent(bed.keeper.to_robot().size());
  }
  EXPECT_EQ(came, said);
}

TEST(LineKeeper, HalfAPacketOfADeadMindNeverReachesTheRobot) {
  KeptBed bed;
  bed.drive_at(0.65);
  const Bytes last = command(Command::velocity, 650);
  for (std::size_t part = 1; part < last.size(); ++part) {
    LineKeeper keeper = bed.keeper;
    keeper.from_mind(ByteView(last).first(part), bed.now);
    keeper.mind_has_died(bed.now);
    const ByteView out = keeper.to_robot();
    const Bytes stop = command(Command::velocity, 0);
    ASSERT_GE(out.size(), stop.size());
    EXPECT_TRUE(std::equal(stop.begin(), stop.end(), out.begin())) << part;
  }
}

TEST(LineKeeper, APacketThatIsOnItsWayIsEndedAndWhatWaitsBehindItIsLeftOut) {
  const Bytes word = command(Command::velocity, 650);
  for (std::size_t gone = 1; gone < word.size(); ++gone) {
    KeptBed bed;
    bed.drive_at(0.65);
    bed.keeper.from_mind(word, bed.now);
    bed.keeper.from_mind(word, bed.now);
    bed.firmware.receive(bed.keeper.to_robot().first(gone), bed.now);
    bed.keeper.sent(gone);
    bed.die();
    EXPECT_EQ(bed.keeper.to_robot().size(),
              word.size() - gone + 2 * command(Command::velocity, 0).size());
    EXPECT_LE(bed.seconds_until_told_to_stand(), 0.02) << gone;
  }
}

TEST(LineKeeper, StopsThroughALineThatTakesAByteAtATime) {
  KeptBed bed;
  bed.drive_at(0.3);
  bed.line_takes = 5;  // a step; 5000 baud
  bed.run(0.2);
  bed.die();
  EXPECT_LT(bed.seconds_until_told_to_stand(), 0.1);
  bed.run(8.0);
  EXPECT_FALSE(bed.firmware.connected());
}

TEST(LineKeeper, SaysAStopAgainUntilTheRobotHears) {
  KeptBed bed;
  bed.drive_at(0.65);
  bed.die();
  // The first stops are lost on the way.
  for (const TimePoint end = bed.now + 400ms; bed.now < end; bed.now += 10ms) {
    bed.keeper.tick(bed.now);
    bed.keeper.sent(bed.keeper.to_robot().size());
  }
  EXPECT_LE(bed.seconds_until_told_to_stand(), 0.15);
}

TEST(LineKeeper, EndsThoughTheRobotSaysNothingAnyMore) {
  LineKeeper keeper;
  keeper.from_mind(command(Command::open, 1), TimePoint(1s));
  keeper.mind_has_died(TimePoint(1s));
  TimePoint now(1s);
  while (!keeper.done() && now < TimePoint(60s)) {
    now += 10ms;
    keeper.tick(now);
    keeper.sent(keeper.to_robot().size());
  }
  EXPECT_LT(now, TimePoint(15s));
}

TEST(LineKeeper, OfALineThatWasClosedOnPurposeSendsWhatIsLeftAndNoMore) {
  KeptBed bed;
  bed.drive_at(0.3);
  const Bytes word = command(Command::stop);
  bed.keeper.from_mind(word, bed.now);
  bed.keeper.mind_lets_go(bed.now);
  bed.heard.clear();
  bed.mind_lives = false;
  bed.run(1.0);
  EXPECT_EQ(bed.heard, word);
  EXPECT_TRUE(bed.keeper.done());
}

TEST(LineKeeper, EveryMotionOfTheProtocolIsStopped) {
  const std::vector<Bytes> motions = {command(Command::velocity, -300),
                                      command(Command::rotation_velocity, 20),
                                      command(Command::rotate, -20),
                                      command(Command::wheels, std::uint8_t{10}, std::uint8_t{10}),
                                      command(Command::move, 2000),
                                      command(Command::heading, 0),
                                      command(Command::turn, 90),
                                      command(Command::turn_on, 45)};
  for (const Bytes& motion : motions) {
    LineKeeper keeper;
    keeper.from_mind(command(Command::open, 1), TimePoint(1s));
    keeper.from_mind(motion, TimePoint(1s));
    keeper.sent(keeper.to_robot().size());
    keeper.tick(TimePoint(1s) + kMindLease + 10ms);
    Bytes stop = command(Command::velocity, 0);
    append(stop, command(Command::rotation_velocity, 0));
    const ByteView out = keeper.to_robot();
    EXPECT_EQ(Bytes(out.begin(), out.end()), stop) << int{motion[3]};
  }
}

TEST(LineKeeper, TakesNoMoreThanItHasRoomFor) {
  LineKeeper keeper;
  Bytes taken;
  const Bytes word = command(Command::velocity, 100);
  for (int i = 0; i < 10000 && keeper.room_for_mind() >= word.size(); ++i) {
    keeper.from_mind(word, TimePoint(1s));
    append(taken, word);
  }
  EXPECT_LT(taken.size(), 3000u);
  const ByteView out = keeper.to_robot();
  EXPECT_EQ(Bytes(out.begin(), out.end()), taken);
  keeper.from_mind(command(Command::open, 1), TimePoint(1s));
  keeper.mind_has_died(TimePoint(1s));
  EXPECT_EQ(keeper.to_robot().size(), 2 * word.size()) << "the stop goes first";
}

}  // namespace
}  // namespace striate::pioneer
