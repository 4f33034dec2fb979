#pragma once

#include <array>
#include <optional>

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/pioneer/arcos/config_pac.hpp"
#include "striate/platform/pioneer/arcos/sip.hpp"
#include "striate/platform/pioneer/robot_model.hpp"

namespace striate::pioneer {

/// One sonar disc's newest reading.
struct DiscReading {
  TimePoint stamp;       ///< when it was told
  double range_m = 0.0;  ///< from the disc; +inf: no echo
  bool told = false;     ///< false: nothing has come from this disc yet
};

/// What the robot has told about itself, in SI units.
struct BaseState {
  TimePoint stamp;  ///< first byte of the newest SIP
  bool told = false;
  Odometry odometry;
  std::array<DiscReading, kMostSonarDiscs> sonar;
  std::span<const Pose2> discs = sonar_discs();  ///< where those of the kind sit, from the axle
  RangeScan laser;                               ///< from the axle; empty: none has come
  double battery_v = 0.0;
  bool stalled_left = false;
  bool stalled_right = false;
  bool bumper_front = false;
  bool bumper_rear = false;
  bool motors_on = false;
  bool stop_pressed = false;      ///< the robot's own STOP button, or its emergency stall
  bool joystick_pressed = false;  ///< the joystick's dead-man button
};

/// Makes a BaseState of packets. The robot's odometry starts anywhere and wraps; what comes out is
/// one unbroken way since the first packet, also when the robot has been rebooted in between.
class BaseTracker {
 public:
  void use(const RobotModel& model) {
    model_ = model;
    state_.discs = model.discs;
    state_.sonar = {};
  }
  /// Bumpers count only where the robot says that it has some: elsewhere the bits float.
  void use_bumpers(bool front, bool rear);
  /// The next packet only seeds the odometry: after a new connection.
  void seed_again() {
    seeded_ = false;
    state_.laser.readings.clear();
  }
  void take(const arcos::Sip& sip, TimePoint stamp);
  /// A whole sweep over the front half circle, from right to left.
  void take_laser(const std::vector<std::uint16_t>& ranges_mm, TimePoint stamp);
  void take_joystick(bool pressed) { state_.joystick_pressed = pressed; }
  [[nodiscard]] const BaseState& state() const { return state_; }

 private:
  void move_on(const arcos::Sip& sip);

  RobotModel model_;
  bool front_bumper_ = false;
  bool rear_bumper_ = false;
  bool seeded_ = false;
  std::uint16_t x_ = 0;
  std::uint16_t y_ = 0;
  std::int16_t heading_ = 0;
  double frame_turn_rad_ = 0.0;  ///< from the robot's frame to ours
  BaseState state_;
};

}  // namespace striate::pioneer
