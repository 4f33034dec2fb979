#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <thread>
#include <vector>

#include "striate/agent/simulated_body.hpp"
#include "striate/base/base64.hpp"
#include "striate/platform/simulator/world_reader.hpp"

/// The simulated robot in real time for rosbridge.mjs, which speaks for it: what it feels goes out,
/// a line of JSON a cycle; speeds come in, "0.3 -0.1" a line, and drive for half a second.
namespace striate {
namespace {

using nlohmann::json;
using Steady = std::chrono::steady_clock;

/// As a TurtleBot's base stops by itself
constexpr auto kDeadline = std::chrono::milliseconds(500);
/// What it calls the beginning: its clock is not that of anybody else.
constexpr std::int64_t kItsBeginning_ns = 1'234'567'890'000'000'000;

/// The newest speeds that were read.
class Speeds {
 public:
  void read_all() {
    for (std::string line; std::getline(std::cin, line);) {
      MotorCommand command;
      if (std::sscanf(line.c_str(), "%lf %lf", &command.forward_m_s, &command.turn_rad_s) != 2) {
        continue;
      }
      const std::lock_guard lock(mutex_);
      newest_ = command;
      came_ = Steady::now();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  [[nodiscard]] MotorCommand newest() {
    const std::lock_guard lock(mutex_);
    return Steady::now() - came_ > kDeadline ? MotorCommand{} : newest_;
  }
  [[nodiscard]] bool ended() {
    const std::lock_guard lock(mutex_);
    return ended_;
  }

 private:
  std::mutex mutex_;
  MotorCommand newest_;
  Steady::time_point came_;
  bool ended_ = false;
};

std::string image_text(const cv::Mat3b& image, bool raw) {
  std::vector<std::uint8_t> bytes;
  if (raw) {
    cv::Mat3b rgb;
    cv::cvtColor(image, rgb, cv::COLOR_BGR2RGB);
    bytes.assign(rgb.datastart, rgb.dataend);
  } else {
    cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, 95});
  }
  return to_base64(bytes);
}

/// The nearest echo of each degree, all round from behind; null where none was asked for.
json ranges_m(const RangeScan& scan) {
  json ranges(std::vector<json>(360));
  for (const RangeReading& echo : scan.readings) {
    const double degree = std::floor(degrees(echo.bearing_rad) + 180.5);
    json& range = ranges[static_cast<std::size_t>(degree) % 360];
    const double distance_m = std::isfinite(echo.distance_m) ? echo.distance_m : 100.0;
    if (range.is_null() || range.get<double>() > distance_m) range = distance_m;
  }
  return ranges;
}

json felt(const Senses& senses, const agent::SimulatedBody& body, bool raw) {
  const StereoFrame& seen = senses.stereo;
  const auto its_time = [](TimePoint time) {
    return std::to_string(kItsBeginning_ns + time.time_since_epoch().count());
  };
  json line{{"now", its_time(senses.now)},
            {"x", senses.odometry.pose.x_m},
            {"y", senses.odometry.pose.y_m},
            {"heading", senses.odometry.pose.heading_rad},
            {"forward", senses.odometry.forward_m_s},
            {"turn", senses.odometry.turn_rad_s},
            {"ranges", ranges_m(senses.laser)},
            {"driven", body.judge().distance_driven_m()},
            {"beyond", body.judge().reached_goal()},
            {"collisions", body.judge().collisions().size()}};
  if (!seen.left.empty()) {
    line["seen"] = {{"at", its_time(seen.stamp)},
                    {"width", seen.left.cols},
                    {"height", seen.left.rows},
                    {"focal", seen.focal_px},
                    {"u", seen.centre_u_px},
                    {"v", seen.centre_v_px},
                    {"baseline", seen.baseline_m},
                    {"left", image_text(seen.left, raw)},
                    {"right", image_text(seen.right, raw)}};
  }
  return line;
}

int run(const std::string& world, const std::string& robot, bool raw) {
  const agent::WorldOptions options{.world = world, .seed = 5};
  agent::RobotSettings settings = agent::load_robot_settings(robot);
  settings.simulator.judge.ends_at_goal = false;
  agent::SimulatedBody body(settings, simulator::load_world(world), options);
  Speeds speeds;
  std::thread([&speeds] { speeds.read_all(); }).detach();
  Senses senses;
  Steady::time_point next = Steady::now();
  while (!speeds.ended() && body.sense(senses)) {
    std::cout << felt(senses, body, raw).dump() << "\n" << std::flush;
    next += body.description().cycle;
    std::this_thread::sleep_until(next);
    MotorCommand command = speeds.newest();
    command.tilt_rad = body.description().resting_tilt_rad;
    body.send(command);
  }
  std::_Exit(0);  // somebody may still read speeds
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: simulated_turtlebot WORLD ROBOT raw|jpeg\n");
    return 2;
  }
  try {
    return striate::run(argv[1], argv[2], std::string(argv[3]) == "raw");
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
