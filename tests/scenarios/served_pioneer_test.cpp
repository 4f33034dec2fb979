#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <thread>

#include "striate/platform/pioneer/pioneer_robot.hpp"
#include "tests/scenarios/served_hall.hpp"
#include "tests/scenarios/striate_process.hpp"

/// The simulated Pioneer behind a real line, driven by our own driver and by the command.
namespace striate::scenarios {
namespace {

using namespace std::chrono_literals;
using pioneer::arcos::Command;
using pioneer::arcos::command;

/// Drives so far and stands; the way by odometry and in truth.
struct Paths {
  double odometry_m = 0.0;
  double true_m = 0.0;
};
Paths drive(const Served& served, pioneer::PioneerRobot& robot, double way_m) {
  Senses senses;
  robot.sense(senses);
  const Pose2 from = senses.odometry.pose;
  const Pose2 true_from = served.state().true_pose;
  const auto gone = [&] {
    return std::hypot(senses.odometry.pose.x_m - from.x_m, senses.odometry.pose.y_m - from.y_m);
  };
  for (int i = 0; i < 100 && gone() < way_m - 0.1; ++i) {
    robot.send({.forward_m_s = 0.4});
    robot.sense(senses);
  }
  for (int i = 0; i < 12 || std::abs(senses.odometry.forward_m_s) > 0.0; ++i) {
    robot.send({});
    robot.sense(senses);
  }
  const Pose2 true_to = served.state().true_pose;
  return {gone(), std::hypot(true_to.x_m - true_from.x_m, true_to.y_m - true_from.y_m)};
}

TEST(ServedPioneer, DrivesAMetreAndTheOdometryAgreesWithTheTruthAgainAndAgain) {
  const Served served;
  for (const double way_m : {1.0, 0.3}) {
    pioneer::PioneerRobot robot({}, served.url());
    const Paths ways = drive(served, robot, way_m);
    EXPECT_GT(ways.true_m, way_m - 0.1);
    EXPECT_LT(ways.true_m, way_m + 0.25);
    EXPECT_NEAR(ways.odometry_m, ways.true_m, 0.03 * ways.true_m + 0.005);
    const pioneer::DriverReport report = robot.driver().report();
    EXPECT_EQ(report.counters.stream.bad_checksum, 0u);
    EXPECT_TRUE(report.base.sonar[0].told && report.base.sonar[15].told);
  }
  EXPECT_LT(served.until([](const served::ServedState& s) { return !s.connected; }, 1.0), 1.0)
      << "it said good-bye";
}

TEST(ServedPioneer, IsDrivenOverAPseudoTerminal) {
  const Served served({.pty = true});
  pioneer::PioneerRobot robot({}, served.url());
  const Paths ways = drive(served, robot, 0.3);
  EXPECT_GT(ways.true_m, 0.2);
  EXPECT_NEAR(ways.odometry_m, ways.true_m, 0.03 * ways.true_m + 0.005);
}

TEST(ServedPioneer, IsDrivenOverABadLine) {
  served::ServeSettings settings;
  settings.faults = {.loss = 0.03, .corruption = 0.0005, .delay_s = 0.03};
  const Served served(settings);
  pioneer::PioneerRobot robot({}, served.url());
  const Paths ways = drive(served, robot, 0.6);
  EXPECT_GT(ways.true_m, 0.5);
  EXPECT_NEAR(ways.odometry_m, ways.true_m, 0.05);
}

TEST(ServedPioneer, StandsHalfASecondAfterTheLastCommand) {
  const Served served;
  pioneer::PioneerRobot robot({}, served.url());
  const auto end = std::chrono::steady_clock::now() + 1s;
  while (std::chrono::steady_clock::now() < end) {
    robot.send({.forward_m_s = 0.3});
    std::this_thread::sleep_for(20ms);
  }
  ASSERT_FALSE(served.state().commanded_to_stand);
  const double took_s = served.until([](auto& s) { return s.commanded_to_stand; }, 3.0);
  RecordProperty("seconds", std::to_string(took_s));
  EXPECT_GT(took_s, 0.4);
  EXPECT_LT(took_s, 0.8) << "500 ms, and what a loaded machine adds";
}

/// The process that holds the line of another; -1: there is none.
pid_t keeper_of(pid_t mind) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string status = read_text(entry.path() / "status");
    const bool keeper = status.find("Name:\tline-keeper\n") != std::string::npos;
    if (keeper && status.find("PPid:\t" + std::to_string(mind) + "\n") != std::string::npos) {
      return std::stoi(entry.path().filename());
    }
  }
  return -1;
}

/// The robot's own watchdog is what is left when the keeper of its line is killed, too.
TEST(ServedPioneer, AClientThatIsKilledWithItsKeeperIsStoppedByTheWatchdog) {
  const Served served;
  const pid_t child = fork();
  if (child == 0) {
    if (freopen("/dev/null", "w", stdout) == nullptr) _exit(99);
    execl(STRIATE_BINARY, STRIATE_BINARY, "drive", served.url().c_str(), "--forward-m-s", "0.3",
          "--for-s", "60", nullptr);
    _exit(98);
  }
  EXPECT_LT(served.until([](auto& s) { return s.true_forward_m_s > 0.29; }, 10.0), 10.0);
  const pid_t keeper = keeper_of(child);
  ASSERT_GT(keeper, 0);
  kill(keeper, SIGKILL);
  kill(child, SIGKILL);
  const double took_s = served.until([](auto& s) { return s.commanded_to_stand; }, 5.0);
  waitpid(child, nullptr, 0);
  RecordProperty("seconds", std::to_string(took_s));
  EXPECT_GT(took_s, 1.5);
  EXPECT_LT(took_s, 2.3) << "the robot's own watchdog of 2 s";
  served.until([](auto& s) { return s.true_forward_m_s == 0.0; }, 3.0);
  // Whoever connects next does not wake the old motion.
  const Pose2 stood = served.state().true_pose;
  pioneer::PioneerRobot next({}, served.url());
  std::this_thread::sleep_for(500ms);
  EXPECT_NEAR(served.state().true_pose.x_m, stood.x_m, 1e-3);
}

TEST(ServedPioneer, AMindWhoseKeeperDiesIsToldAtOnce) {
  const Served served;
  pioneer::PioneerRobot robot({}, served.url());
  const pid_t keeper = keeper_of(getpid());
  ASSERT_GT(keeper, 0);
  kill(keeper, SIGKILL);
  Senses senses;
  EXPECT_THROW(
      {
        for (int i = 0; i < 10; ++i) robot.sense(senses);
      },
      std::runtime_error);
}

TEST(ServedPioneer, ALinkThatBreaksNeedsAReset) {
  served::ServeSettings settings;
  settings.faults.break_at_s = 3.0;
  const Served served(settings);
  const pioneer::SteadyClock clock;
  pioneer::DriverThread driver({}, pioneer::make_transport(served.url()), clock);
  ASSERT_TRUE(driver.wait_until_it_can_drive(5s));
  const auto drive_for = [&](std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end) {
      driver.command({.forward_m_s = 0.2});
      std::this_thread::sleep_for(20ms);
    }
  };
  drive_for(500ms);
  served.until([](auto& s) { return s.time_s > 0.0 && s.true_forward_m_s > 0.1; }, 3.0);
  while (driver.report().counters.connections < 2 && driver.report().base.stamp < TimePoint(12s)) {
    drive_for(100ms);
    if (clock.now() > TimePoint(15s)) break;
  }
  ASSERT_EQ(driver.report().counters.connections, 2u);
  drive_for(600ms);
  EXPECT_EQ(driver.report().hold, pioneer::HoldReason::link_lost);
  EXPECT_TRUE(served.state().commanded_to_stand);
  driver.reset();
  drive_for(800ms);
  EXPECT_FALSE(served.state().commanded_to_stand);
}

/// The served robot in virtual time, fed with bytes.
class BareRobot {
 public:
  BareRobot() : robot(hall(), 1, {}, {}) {
    for (const Command id : {Command::sync0, Command::sync1, Command::sync2}) say(command(id));
    say(command(Command::open, 1));
  }
  void say(const Bytes& bytes) { robot.firmware().receive(bytes, robot.now()); }
  std::vector<pioneer::arcos::Packet> run(double seconds) {
    std::vector<pioneer::arcos::Packet> packets;
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) robot.step();
    stream.push(robot.firmware().take_output());
    while (auto packet = stream.next()) packets.push_back(std::move(*packet));
    return packets;
  }
  served::ServedPioneer robot;
  pioneer::arcos::PacketStream stream;
};

TEST(ServedPioneer, FiresItsSonarAsTheRealDiscsDo) {
  BareRobot bare;
  (void)bare.run(1.0);
  std::multiset<int> fired;
  std::size_t most = 0;
  for (const auto& packet : bare.run(3.2)) {
    const auto sip = pioneer::arcos::read_sip(packet);
    ASSERT_TRUE(sip);
    most = std::max(most, sip->sonar.size());
    for (const auto& reading : sip->sonar) fired.insert(reading.disc);
  }
  EXPECT_LE(most, 6u) << "two or three a packet and array";
  for (int disc = 0; disc < 16; ++disc) {
    EXPECT_NEAR(static_cast<double>(fired.count(disc)), 10.0, 1.0) << "each 320 ms, disc " << disc;
  }
}

TEST(ServedPioneer, SendsALaserInBandWhereItIsAskedFor) {
  BareRobot bare;
  for (const auto& packet : bare.run(0.5)) EXPECT_NE(packet.id, pioneer::arcos::SimLaser::kId);
  bare.say(command(Command::laser_start, -90));
  bare.say(command(Command::laser_end, 90));
  bare.say(command(Command::laser_increment, 100));
  bare.say(command(Command::laser_mode, 2));
  std::vector<std::uint16_t> sweep;
  int packets = 0;
  for (const auto& packet : bare.run(1.0)) {
    const auto part = pioneer::arcos::read_sim_laser(packet);
    if (!part) continue;
    ++packets;
    sweep.resize(part->total);
    std::copy(part->ranges_mm.begin(), part->ranges_mm.end(), sweep.begin() + part->first);
  }
  EXPECT_NEAR(packets, 60, 6);
  ASSERT_EQ(sweep.size(), 181u);
  const double side_m = hall().width_m / 2.0;
  EXPECT_NEAR(sweep.front() / 1000.0, side_m, 0.15) << "the wall at its right";
  EXPECT_NEAR(sweep.back() / 1000.0, side_m, 0.15);
  EXPECT_EQ(sweep[90], 8000) << "nothing within range ahead";
}

TEST(FaultyWay, LosesSpoilsDelaysAndFallsSilentAsItIsAsked) {
  const Bytes chunk(100, 0x55);
  served::FaultyWay lossy({.loss = 0.3}, 1);
  std::size_t came = 0;
  for (int i = 0; i < 1000; ++i) lossy.put(chunk, 0.0);
  came = lossy.take(0.0).size() / chunk.size();
  EXPECT_NEAR(static_cast<double>(came), 700.0, 50.0);

  served::FaultyWay spoiled({.corruption = 0.1}, 1);
  for (int i = 0; i < 100; ++i) spoiled.put(chunk, 0.0);
  const Bytes bytes = spoiled.take(0.0);
  EXPECT_NEAR(static_cast<double>(bytes.size() - std::count(bytes.begin(), bytes.end(), 0x55)),
              1000.0, 120.0);

  served::FaultyWay late({.delay_s = 0.2}, 1);
  late.put(chunk, 1.0);
  EXPECT_TRUE(late.take(1.19).empty());
  EXPECT_EQ(late.take(1.2), chunk);

  served::FaultyWay silent({.silent_at_s = 2.0, .silent_for_s = 1.0}, 1);
  silent.put(chunk, 2.5);
  EXPECT_TRUE(silent.take(9.0).empty());
  silent.put(chunk, 3.1);
  EXPECT_EQ(silent.take(9.0), chunk);
}

TEST(DriveCommand, TellsAWrongPlaceAndARobotThatIsNotThere) {
  EXPECT_EQ(striate({"drive", "http://robot"}).exit_code, 2);
  EXPECT_EQ(striate({"sim", "config/worlds/short.yaml"}).exit_code, 2);
}

}  // namespace
}  // namespace striate::scenarios
