#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "striate/platform/pioneer/base_driver.hpp"
#include "striate/platform/pioneer/firmware/arcos_firmware.hpp"

namespace striate::pioneer {

/// A line in memory that a test can cut.
class MemoryLine : public Transport {
 public:
  void open() override { open_ = plugged; }
  void close() override {
    open_ = false;
    to_program.clear();
  }
  [[nodiscard]] bool is_opening() const override { return false; }
  [[nodiscard]] bool is_open() const override { return open_; }
  [[nodiscard]] Bytes read() override {
    Bytes bytes;
    bytes.swap(to_program);
    return bytes;
  }
  void write(ByteView bytes) override { append(to_robot, bytes); }
  void wait(Duration /*at_most*/) override {}
  void unplug() {
    plugged = false;
    close();
    to_robot.clear();
  }

  bool plugged = true;
  Bytes to_program;
  Bytes to_robot;

 private:
  bool open_ = false;
};

/// Driver and firmware on one line, in steps of 10 ms of virtual time.
class TestBed {
 public:
  explicit TestBed(const BaseDriverSettings& settings = {}, const FirmwareSettings& robot = {})
      : driver(settings, line), firmware(robot) {}

  static constexpr Duration kStep = std::chrono::milliseconds(10);

  void step() {
    now += kStep;
    if (program_runs) {
      if (command) driver.gate().command(*command, now);
      driver.step(now);
    }
    if (!robot_hears) line.to_robot.clear();
    Bytes bytes;
    bytes.swap(line.to_robot);
    if (spoil) spoil(bytes);
    if (!bytes.empty()) firmware.receive(bytes, now);
    senses.odometry.forward_m_s = firmware.forward_m_s();
    senses.odometry.turn_rad_s = firmware.turn_rad_s();
    Pose2& pose = senses.odometry.pose;
    const double dt_s = to_seconds(kStep);
    pose.heading_rad = wrap_angle(pose.heading_rad + firmware.turn_rad_s() * dt_s);
    pose.x_m += firmware.forward_m_s() * dt_s * std::cos(pose.heading_rad);
    pose.y_m += firmware.forward_m_s() * dt_s * std::sin(pose.heading_rad);
    senses.true_pose = pose;
    firmware.step(now, kStep, senses);
    const auto disc = static_cast<std::size_t>(steps_++ / 4 % 8);
    if (steps_ % 4 == 1) {
      firmware.sonar(disc, front_m);
      firmware.sonar(8 + disc, std::numeric_limits<double>::infinity());
    }
    if (laser_speaks && steps_ % 10 == 0) firmware.laser(std::vector<std::uint16_t>(181, 3000));
    Bytes answer = firmware.take_output();
    if (!robot_speaks) answer.clear();
    if (spoil) spoil(answer);
    if (line.is_open()) append(line.to_program, answer);
  }

  void run(double seconds) {
    const TimePoint end = now + from_seconds(seconds);
    while (now < end) step();
  }
  /// Seconds until it holds; the limit when it never does.
  double run_until(const std::function<bool()>& holds, double limit_s = 10.0) {
    const TimePoint begin = now;
    while (!holds() && now - begin < from_seconds(limit_s)) step();
    return to_seconds(now - begin);
  }
  /// A connection, motors on, and the robot drives at 0.3 m/s.
  void drive() {
    command = MotorCommand{.forward_m_s = 0.3};
    run_until([&] { return std::abs(firmware.forward_m_s() - 0.3) < 1e-3; });
  }
  [[nodiscard]] const BaseState& base() const { return driver.session().base(); }

  MemoryLine line;
  BaseDriver driver;
  ArcosFirmware firmware;
  FirmwareSenses senses;
  TimePoint now;
  std::optional<MotorCommand> command;  ///< given anew each step
  std::function<void(Bytes&)> spoil;    ///< both ways
  double front_m = std::numeric_limits<double>::infinity();
  bool program_runs = true;
  bool robot_hears = true;
  bool robot_speaks = true;
  bool laser_speaks = true;

 private:
  int steps_ = 0;
};

}  // namespace striate::pioneer
