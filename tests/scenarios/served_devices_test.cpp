#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "striate/agent/robot_settings.hpp"
#include "striate/app/doctor/devices.hpp"
#include "striate/platform/pioneer/pioneer_robot.hpp"
#include "striate/platform/served/robot_server.hpp"
#include "striate/platform/simulator/render/renderer_images.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "tests/scenarios/served_hall.hpp"
#include "tests/scenarios/striate_process.hpp"

/// Turret, laser and camera of the served Pioneer, through the drivers of a real one.
namespace striate::scenarios {
namespace {

using namespace std::chrono_literals;

/// Images in real time: a sanitizer's program is too slow for them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kTooSlow = true;
#else
constexpr bool kTooSlow = false;
#endif

simulator::World short_world() {
  return simulator::load_world(STRIATE_SOURCE_DIR "/config/worlds/short.yaml");
}

/// A robot with all its devices at any free ports, in a thread of its own.
class ServedRobot {
 public:
  explicit ServedRobot(served::DeviceFaults faults = {},
                       const simulator::FaultSettings& simulated = {})
      : world_(short_world()),
        robot_(world_, 3, with(simulated), {}),
        pictures_(world_, robot_.plan(), agent::RobotSettings{}.camera, 3),
        server_(robot_, &pictures_, settings_for(faults), [](const std::string&) {}),
        thread_([this] { server_.run([this] { return !ends_; }); }) {}
  ~ServedRobot() {
    ends_ = true;
    thread_.join();
  }
  [[nodiscard]] served::ServedState state() const { return server_.state(); }
  [[nodiscard]] pioneer::PioneerSettings settings() const {
    const served::ServedUrls& urls = server_.urls();
    pioneer::PioneerSettings settings;
    settings.devices = {urls.base, urls.turret, urls.laser, urls.camera};
    return settings;
  }
  /// As a file for --robot.
  void write_robot_file(const std::string& file) const {
    const served::ServedUrls& urls = server_.urls();
    std::ofstream(file) << "pioneer:\n  devices:\n    base: " << urls.base
                        << "\n    turret: " << urls.turret << "\n    laser: " << urls.laser
                        << "\n    camera: " << urls.camera << "\n";
  }

 private:
  static served::ServeSettings settings_for(served::DeviceFaults faults) {
    served::ServeSettings settings;
    settings.port = 0;
    settings.devices = faults;
    settings.camera_latency_s = simulator::SensorSettings{}.camera_latency_s;
    return settings;
  }
  static simulator::SimulatorSettings with(const simulator::FaultSettings& faults) {
    simulator::SimulatorSettings settings;
    settings.faults = faults;
    return settings;
  }
  simulator::World world_;
  served::ServedPioneer robot_;
  simulator::RendererImages pictures_;
  served::RobotServer server_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

/// Drives at 0.2 m/s, looking about, until the robot is told to stand.
/// @returns seconds since its connection.
double drives_until_s(const ServedRobot& served, pioneer::PioneerRobot& robot) {
  Senses senses;
  bool drove = false;
  served::ServedState state = served.state();
  for (const double begin_s = state.time_s; state.time_s - begin_s < 12.0; state = served.state()) {
    drove = drove || state.true_forward_m_s > 0.15;
    if (drove && state.commanded_to_stand) break;
    robot.send({.forward_m_s = 0.2, .pan_rad = 0.5 * std::sin(2.0 * state.time_s)});
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_TRUE(drove);
  return state.connected_s;
}

void expect_it_stays_so(const ServedRobot& served, pioneer::PioneerRobot& robot) {
  Senses senses;
  for (int i = 0; i < 20; ++i) {
    robot.sense(senses);
    robot.send({.forward_m_s = 0.2});
  }
  EXPECT_TRUE(served.state().commanded_to_stand);
  EXPECT_EQ(served.state().true_forward_m_s, 0.0);
}

TEST(ServedDevices, AllSensesComeTheSameWayAsFromARealRobot) {
  if (kTooSlow) GTEST_SKIP() << "under a sanitizer";
  const ServedRobot served;
  pioneer::PioneerRobot robot(served.settings());
  Senses senses;
  for (int i = 0; i < 25; ++i) {
    robot.sense(senses);
    robot.send({.pan_rad = 0.4, .tilt_rad = -0.2});
  }
  EXPECT_NEAR(senses.head.pan_rad, 0.4, 0.01);
  EXPECT_NEAR(senses.stereo.head.tilt_rad, -0.2, 0.01);
  EXPECT_NEAR(served.state().true_head.pan_rad, 0.4, 0.01);
  EXPECT_EQ(senses.stereo.left.size(), cv::Size(320, 240));
  EXPECT_EQ(senses.stereo.right.size(), senses.stereo.left.size());
  EXPECT_NEAR(senses.stereo.baseline_m, 0.12, 1e-6);
  EXPECT_NEAR(senses.stereo.focal_px, 160.0 / std::tan(radians(21.5)), 0.1);
  const double age_s = to_seconds(senses.now - senses.stereo.stamp);
  EXPECT_GT(age_s, 0.08) << "light takes its time";
  EXPECT_LT(age_s, 0.5);
  ASSERT_GT(senses.laser.readings.size(), 600u);
  const RangeReading& left = *std::min_element(
      senses.laser.readings.begin(), senses.laser.readings.end(), [](auto& a, auto& b) {
        return std::abs(a.bearing_rad - radians(75.0)) < std::abs(b.bearing_rad - radians(75.0));
      });
  EXPECT_NEAR(left.distance_m, 1.2 / std::cos(radians(15.0)), 0.2) << "the wall at its left";
  EXPECT_LT(to_seconds(senses.now - senses.laser.stamp), 0.5);
  EXPECT_GT(senses.sonar.readings.size(), 12u);
}

TEST(ServedDevices, ALaserThatFallsSilentStopsTheRobot) {
  const ServedRobot served({.laser_silent_at_s = 4.0});
  pioneer::PioneerRobot robot(served.settings());
  const double took_s = drives_until_s(served, robot) - 4.0;
  RecordProperty("seconds", std::to_string(took_s));
  EXPECT_GT(took_s, 0.2);
  EXPECT_LT(took_s, 0.8) << "500 ms, and what a loaded machine adds";
  EXPECT_EQ(robot.driver().report().hold, pioneer::HoldReason::laser_stale);
  expect_it_stays_so(served, robot);
}

TEST(ServedDevices, ATurretThatIsHeldStopsTheRobot) {
  const ServedRobot served({.turret_sticks_at_s = 3.0});
  pioneer::PioneerRobot robot(served.settings());
  const double took_s = drives_until_s(served, robot) - 3.0;
  RecordProperty("seconds", std::to_string(took_s));
  EXPECT_GT(took_s, 0.5);
  EXPECT_LT(took_s, 1.5) << "a second without progress";
  EXPECT_EQ(robot.driver().report().hold, pioneer::HoldReason::head_fails);
  expect_it_stays_so(served, robot);
}

TEST(ServedDevices, TheCorridorMissionIsDrivenThroughTheDriversOfARealRobot) {
  if (kTooSlow) GTEST_SKIP() << "under a sanitizer";
  const ServedRobot served;
  const TemporaryFolder folder;
  served.write_robot_file(folder / "robot.yaml");
  const Ended ended =
      striate({"run", "config/tasks/corridor.yaml", "--robot", folder / "robot.yaml", "--var",
               "way=11.3 m", "--result", folder / "r.json", "--memory", folder / "robot.db"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err << ended.out;
  const served::ServedState state = served.state();
  EXPECT_TRUE(state.beyond_goal);
  EXPECT_EQ(state.collisions, 0u);
  EXPECT_TRUE(state.commanded_to_stand);
  const auto result = nlohmann::json::parse(read_text(folder / "r.json"));
  EXPECT_EQ(result.at("outcome"), "success");
  EXPECT_NEAR(result.at("distance_m").get<double>(), 11.5, 1.0);
  const Ended episodes = striate({"memory", folder / "robot.db", "episodes"});
  EXPECT_THAT(episodes.out, testing::HasSubstr("success")) << episodes.err;
}

TEST(ServedDevices, TheMissionStandsWhileTheCameraIsBlind) {
  if (kTooSlow) GTEST_SKIP() << "under a sanitizer";
  const ServedRobot served({}, {.camera_stops_at_s = 9.0});
  const TemporaryFolder folder;
  served.write_robot_file(folder / "robot.yaml");
  std::thread watcher;
  double stood_at_s = 0.0;
  std::atomic<bool> ended{false};
  watcher = std::thread([&] {
    while (!ended && stood_at_s == 0.0) {
      const served::ServedState state = served.state();
      if (state.time_s > 9.0 && state.commanded_to_stand) stood_at_s = state.time_s;
      std::this_thread::sleep_for(5ms);
    }
  });
  const Ended run =
      striate({"run", "config/tasks/corridor.yaml", "--robot", folder / "robot.yaml", "--quiet"},
              {.after = 12s});
  ended = true;
  watcher.join();
  EXPECT_EQ(run.exit_code, 130) << run.err << run.out;
  RecordProperty("seconds", std::to_string(stood_at_s - 9.0));
  EXPECT_GT(stood_at_s, 9.0);
  EXPECT_LT(stood_at_s, 10.2);
}

/// What the doctor says of a place, as grade and words.
const app::Finding& said_of(const app::Findings& findings, const std::string& place) {
  for (const app::Finding& finding : findings) {
    if (finding.about.rfind(place + " ", 0) == 0) return finding;
  }
  ADD_FAILURE() << "nothing is said of the " << place;
  return findings.front();
}

TEST(ServedDevices, TheDoctorTellsDevicesThatWereExchanged) {
  const Served served;
  const served::ServedUrls& urls = served.urls();
  pioneer::PioneerSettings right;
  right.devices = {urls.base, urls.turret, urls.laser, {}};
  const app::Findings good = app::look_at_places(right);
  EXPECT_EQ(good.size(), 3u);
  for (const app::Finding& finding : good) {
    EXPECT_EQ(finding.grade, app::Finding::Grade::good) << finding.about << ": " << finding.what;
  }
  pioneer::PioneerSettings exchanged;
  exchanged.devices = {urls.laser, urls.base, urls.turret, {}};
  const app::Findings wrong = app::look_at_places(exchanged);
  for (const app::Finding& finding : wrong) {
    EXPECT_EQ(finding.grade, app::Finding::Grade::wrong) << finding.about;
  }
  EXPECT_THAT(said_of(wrong, "base").what, testing::HasSubstr("a Hokuyo laser, not a base"));
  EXPECT_THAT(said_of(wrong, "turret").what, testing::HasSubstr("a base, not a turret"));
  EXPECT_THAT(said_of(wrong, "laser").what, testing::HasSubstr("a turret of AX-12A servos, not a"));
}

TEST(ServedDevices, AnLms200IsDrivenByItsDriver) {
  served::ServedDevices devices;
  devices.laser = pioneer::LaserKind::lms200;
  const Served served({}, devices);
  pioneer::PioneerSettings settings;
  settings.devices = {served.urls().base, {}, served.urls().laser, {}};
  settings.laser.kind = pioneer::LaserKind::lms200;
  EXPECT_FALSE(app::any_wrong(app::look_at_places(settings)));
  pioneer::PioneerRobot robot(settings);
  Senses senses;
  for (int i = 0; i < 20 && senses.laser.readings.empty(); ++i) robot.sense(senses);
  ASSERT_EQ(senses.laser.readings.size(), 181u);
  EXPECT_NEAR(senses.laser.readings.front().distance_m, hall().width_m / 2.0, 0.15);
}

TEST(SimCommand, WarnsWhereEverybodyOnTheNetworkMayDrive) {
  const auto serve = [](const std::string& address) {
    return striate(
        {"sim", "config/worlds/short.yaml", "--serve", "--port", "0", "--listen", address},
        {.once_it_says = "turret"});
  };
  EXPECT_THAT(serve("0.0.0.0").err, testing::HasSubstr("everybody on the network"));
  EXPECT_EQ(serve("127.0.0.1").err, "");
}

TEST(RunCommand, WithoutAWorldTellsWhatIsMissing) {
  const Ended no_robot = striate({"run", "config/tasks/corridor.yaml"});
  EXPECT_EQ(no_robot.exit_code, 2);
  EXPECT_THAT(no_robot.err, testing::HasSubstr("config/robots/pioneer.yaml"));
  EXPECT_EQ(striate({"run", "config/tasks/corridor.yaml", "--robot", "config/robots/pioneer.yaml",
                     "--var", "way"})
                .exit_code,
            2);
}

}  // namespace
}  // namespace striate::scenarios
