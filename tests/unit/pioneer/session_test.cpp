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
  return bed.driver.session().state() == SessionState::ready;
}

TEST(Session, SpeaksTheHandshakeAndStopsBeforeAnythingElse) {
  Session session({});
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
  EXPECT_EQ(session.state(), SessionState::opening);
  session.receive(arcos::encode(arcos::write_sip({})), now);
  EXPECT_EQ(session.take_output(), command(Command::config, 1));
}

TEST(Session, GetsReadyAndBelievesTheConfigurationOfTheRobot) {
  TestBed bed;
  EXPECT_LT(bed.run_until([&] { return ready(bed); }), 1.0);
  ASSERT_TRUE(bed.driver.session().config());
  EXPECT_EQ(bed.driver.session().config()->velocity_top_mm_s, 1000);
  EXPECT_DOUBLE_EQ(bed.driver.session().most_forward_mm_s(), 750.0);
  EXPECT_LT(bed.run_until([&] { return bed.base().motors_on; }), 1.0);
}

TEST(Session, GoesOnWithoutAConfigurationAfterASecond) {
  Session session({});
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
  EXPECT_EQ(session.state(), SessionState::ready);
  EXPECT_GE(asked, 4);
  EXPECT_DOUBLE_EQ(session.model().distance_mm, 0.485);
}

TEST(Session, RefusesARobotOfAnUnknownKindUnlessForced) {
  const FirmwareSettings strange{.subclass = "patrolbot-sh"};
  TestBed refused({}, strange);
  refused.run(2.0);
  EXPECT_EQ(refused.driver.session().state(), SessionState::refused);
  EXPECT_THAT(refused.driver.session().trouble(), testing::HasSubstr("patrolbot-sh"));
  EXPECT_FALSE(refused.line.is_open());
  BaseDriverSettings settings;
  settings.session.force_unknown_model = true;
  TestBed forced(settings, strange);
  EXPECT_LT(forced.run_until([&] { return ready(forced); }), 1.0);
}

TEST(Session, EndsAnOlderConnectionFirstAndItsMotionDoesNotWake) {
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
    while (second.session().state() != SessionState::ready && waited_s < 5.0) {
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

TEST(Session, ComesThroughAHandshakeOfWhichAnyAnswerIsLost) {
  for (int lost = 0; lost < 4; ++lost) {
    TestBed bed;
    int packets = 0;
    bed.spoil = [&](Bytes& bytes) {
      if (!bytes.empty() && bytes[3] <= 2 && packets++ / 2 == lost) bytes.clear();
    };
    EXPECT_LT(bed.run_until([&] { return ready(bed); }), 4.0) << lost;
  }
}

TEST(Session, BacksOffLongerEachTimeWhileNobodyAnswers) {
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

TEST(Session, ReconnectsAfterTheRobotHasBeenSwitchedOffAndOn) {
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

TEST(Session, ClosesWithAStopMotorsOffAndGoodbye) {
  TestBed bed;
  bed.drive();
  bed.driver.close();
  bed.command.reset();
  bed.run(0.1);
  EXPECT_FALSE(bed.firmware.connected());
  EXPECT_FALSE(bed.firmware.motors_on());
  EXPECT_FALSE(bed.line.is_open());
}

TEST(Session, CountsWhatComesBadByKind) {
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

TEST(Session, ConnectsDrivesAndDisconnectsAgainAndAgain) {
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

TEST(Firmware, AnswersTheRecordedClients) {
  const auto files = reference::arcos_captures(STRIATE_SHARED_DATA);
  if (files.empty()) GTEST_SKIP() << "no captures below " STRIATE_SHARED_DATA;
  for (const auto& file : files) {
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
    EXPECT_EQ(configs, file.string().find("p2os") == std::string::npos ? 1 : 0) << file;
    EXPECT_EQ(firmware.counters().bad_checksum, 0u) << file;
  }
}

}  // namespace
}  // namespace striate::pioneer
