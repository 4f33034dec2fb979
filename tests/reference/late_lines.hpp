#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "striate/agent/robot_settings.hpp"
#include "striate/platform/pioneer/pioneer_settings.hpp"
#include "striate/platform/served/robot_server.hpp"
#include "striate/platform/simulator/render/renderer_images.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "tests/reference/delaying_relay.hpp"
#include "tests/reference/temporary_folder.hpp"

/// A mission of the command `striate` that drives a served Pioneer through its real drivers, over
/// lines that may get late.
namespace striate::reference {

/// A program that runs beside the test; it is ended with this.
class RunningProgram {
 public:
  /// @param folder to run in; @param output file for what it says
  RunningProgram(std::vector<std::string> words, const std::string& folder,
                 const std::string& output) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    child_ = fork();
    if (child_ != 0) return;
    const int nothing = open("/dev/null", O_RDONLY);
    const int out = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (chdir(folder.c_str()) != 0 || dup2(nothing, 0) < 0 || dup2(out, 1) < 0 ||
        dup2(out, 2) < 0) {
      _exit(99);
    }
    execv(argv[0], argv.data());
    _exit(98);
  }
  ~RunningProgram() {
    signal(SIGCONT);
    signal(SIGINT);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (waitpid(child_, nullptr, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > end) signal(SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  void signal(int number) const { kill(child_, number); }

 private:
  pid_t child_ = -1;
};

enum class LateLine { to_base, from_base, camera, laser, turret, all };
inline constexpr std::array<const char*, 6> kLateLines{
    "base, to the robot", "base, from the robot", "camera", "laser", "turret", "all, both ways"};

/// The long corridor, in which a mission drives for minutes.
class LateMission {
 public:
  LateMission(const std::string& striate, const std::string& source_dir)
      : striate_(striate),
        source_dir_(source_dir),
        world_(simulator::load_world(source_dir + "/config/worlds/corridor_a.yaml")),
        robot_(world_, 3, {}, {}),
        pictures_(world_, robot_.plan(), agent::RobotSettings{}.camera, 3),
        server_(robot_, &pictures_, settings(), [](const std::string&) {}),
        base_(server_.urls().base),
        turret_(server_.urls().turret),
        laser_(server_.urls().laser),
        camera_(server_.urls().camera),
        thread_([this] { server_.run([this] { return !ends_; }); }) {}
  ~LateMission() {
    program_.reset();
    ends_ = true;
    thread_.join();
  }

  [[nodiscard]] served::ServedState state() const { return server_.state(); }
  [[nodiscard]] const RunningProgram& program() const { return *program_; }
  [[nodiscard]] std::string said() const {
    std::ifstream stream(folder_ / "out");
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  void late(LateLine line, double seconds) {
    const bool all = line == LateLine::all;
    if (all || line == LateLine::to_base) base_.delay_to_server(seconds);
    if (all || line == LateLine::from_base) base_.delay_from_server(seconds);
    for (auto& [which, relay] : {std::pair{LateLine::camera, &camera_},
                                 {LateLine::laser, &laser_},
                                 {LateLine::turret, &turret_}}) {
      if (!all && which != line) continue;
      relay->delay_from_server(seconds);
      if (all || line == LateLine::turret) relay->delay_to_server(seconds);
    }
  }
  /// Lets nothing through, and then all at once.
  void hold(bool on) {
    for (DelayingRelay* relay : {&base_, &turret_, &laser_, &camera_}) {
      relay->hold_to_server(on);
      relay->hold_from_server(on);
    }
  }

  /// Where the devices are, behind their relays.
  [[nodiscard]] pioneer::DevicePlaces places() const {
    return {base_.url(), turret_.url(), laser_.url(), camera_.url()};
  }
  void start() {
    const std::string file = folder_ / "robot.yaml";
    std::ofstream(file) << "pioneer:\n  devices:\n    base: " << base_.url()
                        << "\n    turret: " << turret_.url() << "\n    laser: " << laser_.url()
                        << "\n    camera: " << camera_.url() << "\n";
    program_ = std::make_unique<RunningProgram>(
        std::vector<std::string>{striate_, "run", "config/tasks/corridor.yaml", "--robot", file,
                                 "--var", "way=50 m"},
        source_dir_, folder_ / "out");
  }
  /// Whether it is as fast within so long.
  [[nodiscard]] bool drives(double m_s, double within_s) const {
    const double begin_s = state().time_s;
    while (state().true_forward_m_s < m_s) {
      if (state().time_s - begin_s > within_s) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }

  struct Watched {
    double last_moved_s = 0.0;  ///< since the beginning of the watch; 0: it never moved
    double fastest_m_s = 0.0;
    double way_m = 0.0;
    bool moves_at_the_end = false;
  };
  /// Watches for so long.
  [[nodiscard]] Watched watch(double for_s) const {
    Watched seen;
    served::ServedState now = state();
    const Pose2 from = now.true_pose;
    for (const double begin_s = now.time_s; now.time_s - begin_s < for_s; now = state()) {
      const double m_s = std::abs(now.true_forward_m_s);
      seen.moves_at_the_end = m_s > kMoves_m_s;
      if (seen.moves_at_the_end) seen.last_moved_s = now.time_s - begin_s;
      seen.fastest_m_s = std::max(seen.fastest_m_s, m_s);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    seen.way_m = std::hypot(now.true_pose.x_m - from.x_m, now.true_pose.y_m - from.y_m);
    return seen;
  }

 private:
  static served::ServeSettings settings() {
    served::ServeSettings settings;
    settings.port = 0;
    settings.camera_latency_s = simulator::SensorSettings{}.camera_latency_s;
    return settings;
  }
  static constexpr double kMoves_m_s = 0.01;

  std::string striate_;
  std::string source_dir_;
  TemporaryFolder folder_;
  simulator::World world_;
  served::ServedPioneer robot_;
  simulator::RendererImages pictures_;
  served::RobotServer server_;
  DelayingRelay base_;
  DelayingRelay turret_;
  DelayingRelay laser_;
  DelayingRelay camera_;
  std::atomic<bool> ends_{false};
  std::unique_ptr<RunningProgram> program_;
  std::thread thread_;
};

}  // namespace striate::reference
