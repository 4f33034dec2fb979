#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <utility>

#include "striate/platform/served/robot_server.hpp"

namespace striate::scenarios {

inline simulator::World hall() {
  simulator::World world;
  world.length_m = 30.0;
  world.goal_beyond_m = 29.0;
  return world;
}

/// A simulated Pioneer's base in an empty hall, served in a thread of its own at any free port.
class Served {
 public:
  explicit Served(served::ServeSettings settings = {}, const served::ServedDevices& devices = {},
                  const RobotDescription& robot = {})
      : robot_(hall(), 1, {}, devices, robot),
        server_(robot_, nullptr, on_any_port(std::move(settings)), [](const std::string&) {}),
        thread_([this] { server_.run([this] { return !ends_; }); }) {}
  ~Served() {
    ends_ = true;
    thread_.join();
  }
  Served(const Served&) = delete;
  Served& operator=(const Served&) = delete;

  [[nodiscard]] const std::string& url() const { return server_.urls().base; }
  [[nodiscard]] const served::ServedUrls& urls() const { return server_.urls(); }
  [[nodiscard]] served::ServedState state() const { return server_.state(); }

  /// Seconds of the robot's time until it holds.
  double until(const std::function<bool(const served::ServedState&)>& holds, double limit_s) const {
    const double begin_s = state().time_s;
    while (!holds(state()) && state().time_s - begin_s < limit_s) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return state().time_s - begin_s;
  }

 private:
  static served::ServeSettings on_any_port(served::ServeSettings settings) {
    settings.port = 0;
    return settings;
  }
  served::ServedPioneer robot_;
  served::RobotServer server_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace striate::scenarios
