#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reference/captures.hpp"
#include "tests/unit/pioneer/test_bed.hpp"

namespace striate::pioneer {
namespace {

using arcos::Command;
using arcos::command;

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) append(all, part);
  return all;
}

bool ready(const TestBed& bed) {
  return bed.driver.session().state() == LinkState::ready;
}

TEST(ArcosSession, SpeaksTheHandshakeAndStopsBeforeAnythingElse) {
  ArcosSession session({});
  TimePoint now;
  session.line_up(now);
  session.tick(now);
  EXPECT_TRUE(session.take_output().empty()) << "it listens first";
  now += std::chrono::milliseconds(260);
  session.tick(now);
  EXPECT_EQ(session.take_output(), command(Command::sync0));
  session.receive(command(Command::sync0), now);
  EXPECT_EQ(session.take_output(), command(Command::sync1));
  session.receive(command(Command::sync1), now);
  EXPECT_EQ(session.take_output(), command(Command::sync2));
  session.receive(arcos::encode(arcos::write_names({"robot", "Pioneer", "p3dx-sh"})), now);
  EXPECT_EQ(session.take_output(), joined({command(Command::open, 1), command(Command::stop)}));
  EXPECT_EQ(session.state(), LinkState::opening);
  session.receive(arcos::encode(arcos::write_sip({})), now);
  EXPECT_EQ(session.take_output(), command(Command::config, 1));
}

TEST(ArcosSession, GetsReadyAndBelievesTheConfigurationOfTheRobot) {
  TestBed bed;
  EXPECT_LT(bed.run_until([&] { return ready(bed); }), 1.0);
  ASSERT_TRUE(bed.driver.session().config());
  EXPECT_EQ(bed.driver.session().config()->velocity_top_mm_s, 1000);
  EXPECT_DOUBLE_EQ(bed.driver.session().most_forward_mm_s(), 750.0);
  EXPECT_LT(bed.run_until([&] { return bed.base().motors_on; }), 1.0);
}

TEST(ArcosSession, GoesOnWithoutAConfigurationAfterASecond) {
  ArcosSession session({});
  TimePoint now;
  session.line_up(now);
  now += std::chrono::milliseconds(260);
  session.tick(now);
  session.receive(command(Command::sync0), now);
  session.receive(command(Command::sync1), now);
  session.receive(arcos::encode(arcos::write_names({"old", "Pioneer", "p3dx"})), now);
  int asked = 0;
  for (int i = 0; i < 15; ++i) {
    now += std::chrono::milliseconds(100);
    session.receive(arcos::encode(arcos::write_sip({})), now);
    session.tick(now);
    if (session.take_output() == command(Command::config, 1)) ++asked;
  }
  EXPECT_EQ(session.state(), LinkState::ready);
  EXPECT_GE(asked, 4);
  EXPECT_DOUBLE_EQ(session.model().distance_mm, 0.485);
}

TEST(ArcosSession, RefusesARobotOfAnUnknownKindUnlessForced) {
  const FirmwareSettings strange{.subclass = "powerbot-sh"};
  TestBed refused({}, strange);
  refused.run(2.0);
  EXPECT_EQ(refused.driver.session().state(), LinkState::refused);
  EXPECT_THAT(refused.driver.session().trouble(), testing::HasSubstr("powerbot-sh"));
  EXPECT_FALSE(refused.line.is_open());
  BaseDriverSettings settings;
  settings.session.force_unknown_model = true;
  TestBed forced(settings, strange);
  EXPECT_LT(forced.run_until([&] { return ready(forced); }), 1.0);
}

TEST(ArcosSession, EndsAnOlderConnectionFirstAndItsMotionDoesNotWake) {
  for (const double pause_s : {0.0, 4.0}) {
    TestBed bed;
    bed.drive();
    // The program dies without a good-bye; another one takes over the line.
    bed.program_runs = false;
    bed.run(pause_s);
    const double before_m = bed.senses.true_pose.x_m;
    bed.line.to_program.clear();
    BaseDriver second({}, bed.line);
    double waited_s = 0.0;
    while (second.session().state() != LinkState::ready && waited_s < 5.0) {
      bed.step();
      second.step(bed.now);
      waited_s += 0.01;
      if (pause_s > 0.0) {
        ASSERT_EQ(bed.firmware.forward_m_s(), 0.0);
      }
    }
    EXPECT_LT(waited_s, 2.0);
    EXPECT_LT(bed.senses.true_pose.x_m - before_m, 0.3);
  }
}

TEST(ArcosSession, ComesThroughAHandshakeOfWhichAnyAnswerIsLost) {
  for (int lost = 0; lost < 4; ++lost) {
    TestBed bed;
    int packets = 0;
    bed.spoil = [&](Bytes& bytes) {
      if (!bytes.empty() && bytes[3] <= 2 && packets++ / 2 == lost) bytes.clear();
    };
    EXPECT_LT(bed.run_until([&] { return ready(bed); }), 4.0) << lost;
  }
}

TEST(ArcosSession, BacksOffLongerEachTimeWhileNobodyAnswers) {
  TestBed bed;
  bed.robot_speaks = false;
  std::vector<double> pauses_s;
  for (int i = 0; i < 3; ++i) {
    bed.run_until([&] { return bed.line.is_open(); }, 20.0);
    bed.run_until([&] { return !bed.line.is_open(); }, 20.0);
    pauses_s.push_back(bed.run_until([&] { return bed.line.is_open(); }, 20.0));
  }
  EXPECT_NEAR(pauses_s[0], 0.5, 0.05);
  EXPECT_NEAR(pauses_s[1], 1.0, 0.05);
  EXPECT_NEAR(pauses_s[2], 2.0, 0.05);
  EXPECT_FALSE(bed.driver.session().trouble().empty());
  bed.robot_speaks = true;
  EXPECT_LT(bed.run_until([&] { return ready(bed); }, 20.0), 10.0);
  EXPECT_TRUE(bed.driver.session().trouble().empty());
}

TEST(ArcosSession, ReconnectsAfterTheRobotHasBeenSwitchedOffAndOn) {
  TestBed bed;
  bed.drive();
  const double before_m = bed.base().odometry.pose.x_m;
  bed.firmware.reboot();
  bed.senses.odometry.pose = {5.0, 5.0, 1.0};  // its own count begins anywhere
  bed.run_until([&] { return bed.driver.session().counters().connections == 2; });
  EXPECT_TRUE(ready(bed));
  bed.run(1.0);
  EXPECT_NEAR(bed.base().odometry.pose.x_m, before_m, 0.1) << "one unbroken way";
}

TEST(ArcosSession, ClosesWithAStopMotorsOffAndGoodbye) {
  TestBed bed;
  bed.drive();
  bed.driver.close();
  bed.command.reset();
  bed.run(0.1);
  EXPECT_FALSE(bed.firmware.connected());
  EXPECT_FALSE(bed.firmware.motors_on());
  EXPECT_FALSE(bed.line.is_open());
}

TEST(ArcosSession, CountsWhatComesBadByKind) {
  TestBed bed;
  bed.run_until([&] { return ready(bed); });
  Bytes bad = arcos::encode(arcos::write_sip({}));
  bad[7] ^= 1;
  append(bad, arcos::encode({0x32, {1, 2, 3}}));
  append(bad, arcos::encode({0xb0, {7}}));
  append(bed.line.to_program, bad);
  bed.run(0.05);
  const LinkCounters counters = bed.driver.session().counters();
  EXPECT_EQ(counters.stream.bad_checksum, 1u);
  EXPECT_EQ(counters.malformed, 1u);
  EXPECT_EQ(counters.last_malformed_id, 0x32);
  EXPECT_EQ(counters.unknown, 1u);
  EXPECT_EQ(counters.last_unknown_id, 0xb0);
  EXPECT_TRUE(ready(bed));
}

TEST(ArcosSession, ConnectsDrivesAndDisconnectsAgainAndAgain) {
  for (int i = 0; i < 20; ++i) {
    TestBed bed;
    bed.drive();
    bed.command = MotorCommand{};
    bed.run(1.5);
    EXPECT_NEAR(bed.base().odometry.pose.x_m, bed.senses.true_pose.x_m, 0.005);
    bed.driver.close();
    bed.run(0.1);
    EXPECT_FALSE(bed.firmware.connected());
  }
}

/// The firmware on wheels that follow it exactly.
struct RollingFirmware {
  void run_to(double time_s) {
    while (to_seconds(now) < time_s) {
      now += TestBed::kStep;
      const double dt_s = to_seconds(TestBed::kStep);
      Pose2& pose = senses.odometry.pose;
      pose.heading_rad = wrap_angle(pose.heading_rad + firmware.turn_rad_s() * dt_s);
      pose.x_m += firmware.forward_m_s() * dt_s * std::cos(pose.heading_rad);
      pose.y_m += firmware.forward_m_s() * dt_s * std::sin(pose.heading_rad);
      senses.odometry.forward_m_s = firmware.forward_m_s();
      senses.odometry.turn_rad_s = firmware.turn_rad_s();
      firmware.step(now, TestBed::kStep, senses);
    }
  }
  ArcosFirmware firmware{FirmwareSettings{}};
  FirmwareSenses senses;
  TimePoint now;
};

TEST(Firmware, DrivesWhereTheRecordedClientsRobotDrove) {
  for (const auto& file : reference::arcos_captures()) {
    RollingFirmware ours;
    arcos::PacketStream theirs;
    BaseTracker recorded;
    recorded.use(*find_model(reference::named(file, "p3dx.hex") ? "p3dx" : "p3dx-sh"));
    double farthest_m = 0.0, off_m = 0.0, off_rad = 0.0;
    bool free = true;  // theirs ran into a wall in the end; ours has none
    for (const reference::Chunk& chunk : reference::read_capture(file)) {
      ours.run_to(chunk.time_s);
      if (chunk.direction == "C>R") ours.firmware.receive(chunk.bytes, ours.now);
      if (chunk.direction != "R>C") continue;
      theirs.push(chunk.bytes);
      while (const auto packet = theirs.next()) {
        const auto sip = arcos::read_sip(*packet);
        if (!sip) continue;
        recorded.take(*sip, ours.now);
        free = free && !recorded.state().stalled_left;
        if (!free) continue;
        const Pose2& there = recorded.state().odometry.pose;
        const Pose2& here = ours.senses.odometry.pose;
        farthest_m = std::max(farthest_m, std::hypot(there.x_m, there.y_m));
        off_m = std::max(off_m, std::hypot(there.x_m - here.x_m, there.y_m - here.y_m));
        off_rad = std::max(off_rad, std::abs(wrap_angle(there.heading_rad - here.heading_rad)));
      }
    }
    // A few centimetres are the time their simulators take from a command to the wheels.
    EXPECT_LT(off_m, 0.06) << file;
    EXPECT_LT(off_rad, 0.05) << file;
    const bool drives = reference::named(file, "drive");
    EXPECT_GT(farthest_m, drives ? 0.5 : -1.0) << file;
  }
}

TEST(Firmware, AnswersTheRecordedClients) {
  for (const auto& file : reference::arcos_captures()) {
    ArcosFirmware firmware({});
    arcos::PacketStream answers;
    TimePoint now;
    int sips = 0, names = 0, configs = 0;
    bool was_connected = false;
    for (const reference::Chunk& chunk : reference::read_capture(file)) {
      if (chunk.direction != "C>R") continue;
      while (to_seconds(now) < chunk.time_s) {
        firmware.step(now, std::chrono::milliseconds(10), {});
        now += std::chrono::milliseconds(10);
      }
      firmware.receive(chunk.bytes, now);
      was_connected = was_connected || firmware.connected();
      answers.push(firmware.take_output());
      while (const auto packet = answers.next()) {
        sips += arcos::read_sip(*packet) ? 1 : 0;
        names += arcos::read_names(*packet) ? 1 : 0;
        configs += arcos::read_config_pac(*packet) ? 1 : 0;
      }
    }
    EXPECT_TRUE(was_connected) << file;
    EXPECT_EQ(names, 1) << file;
    EXPECT_GT(sips, 20) << file;
    EXPECT_EQ(configs, reference::named(file, "p2os") ? 0 : 1) << file;
    EXPECT_EQ(firmware.counters().bad_checksum, 0u) << file;
  }
}

}  // namespace
}  // namespace striate::pioneer
