#pragma once

#include "striate/base/limits.hpp"
#include "striate/config/settings.hpp"

namespace striate::simulator {

/// How the base moves, and what the body's own watchdog does.
struct BaseSettings {
  double command_latency_s = 0.06;  ///< from send() to the wheels
  double watchdog_s =               ///< without a command for this long the wheels stop
      to_seconds(kCommandLease);    ///< without a command for this long the wheels stop
  double stall_after_s = 0.2;       ///< of pushing against something
  double start_offset_m = 0.03;     ///< deviation of the true start from the world's, each axis
  double start_turn_rad = 0.035;  ///< 2 deg, deviation of the first heading: placed by hand (ours)
  double battery_start_v = kFullBattery_v;  ///< full lead batteries at rest, 2.12 V a cell
  double battery_drop_v_per_h = 0.6;        ///< standing; driving takes as much again per 300 m
};

template <class V>
void visit(V& v, BaseSettings& s) {
  using config::Unit;
  v.number("command_latency", s.command_latency_s, Unit::duration, {0.0, 1.0},
           "time from a command to the wheels");
  v.number("watchdog", s.watchdog_s, Unit::duration, {0.1, 10.0},
           "the wheels stop after this time without a command");
  v.number("stall_after", s.stall_after_s, Unit::duration, {0.05, 5.0},
           "pushing for this long counts as a stall");
  v.number("start_offset", s.start_offset_m, Unit::length, {0.0, 0.2},
           "deviation of the start by seed");
  v.number("start_turn", s.start_turn_rad, Unit::angle, {0.0, 0.5},
           "deviation of the first heading by seed");
  v.number("battery_start", s.battery_start_v, Unit::none, {10.0, 14.0}, "volts at the start");
  v.number("battery_drop_per_hour", s.battery_drop_v_per_h, Unit::none, {0.0, 20.0},
           "volts lost in an hour of standing");
}

/// What is wrong with the senses, drawn anew for each seed.
struct SensorSettings {
  /// Deviation of the scale of ways: 0.75 % of the way, drawn anew each run
  double odometry_way_error = 0.0075;
  /// Deviation of the scale of turns: 0.75 % of the turning, drawn anew each run
  double odometry_turn_error = 0.0075;
  double odometry_drift_rad_m = 0.0005;  ///< deviation of the turn that each metre seems to make
  double sonar_range_m = 5.0;            ///< farthest that a P3-DX tells; no echo is 5000 mm
  double sonar_half_beam_rad = 0.22;     ///< 12.5 deg: half the beam of a P3-DX's disc
  double laser_range_m = 8.0;            ///< as the lasers' 13 bits of mm tell (8.19 m)
  /// Deviation of a reading; URG-04LX data sheet: 10 mm up to 1 m
  double laser_noise_m = 0.01;
  double servo_speed_rad_s = 2.0;   ///< a third of an AX-12A's 6.2 rad/s without load
  double camera_period_s = 0.1;     ///< an image each cycle of the paper's 10 Hz
  double camera_latency_s = 0.085;  ///< from light to image, as a real stereo head has
};

template <class V>
void visit(V& v, SensorSettings& s) {
  using config::Unit;
  v.number("odometry_way_error", s.odometry_way_error, Unit::fraction, {0.0, 0.2},
           "deviation of the scale of ways");
  v.number("odometry_turn_error", s.odometry_turn_error, Unit::fraction, {0.0, 0.2},
           "deviation of the scale of turns");
  v.number("odometry_drift", s.odometry_drift_rad_m, Unit::angle, {0.0, 0.1},
           "deviation of the turn that each metre seems to make");
  v.number("sonar_range", s.sonar_range_m, Unit::length, {0.5, 10.0}, "farthest echo");
  v.number("sonar_half_beam", s.sonar_half_beam_rad, Unit::angle, {0.0, 0.6}, "half the beam");
  v.number("laser_range", s.laser_range_m, Unit::length, {0.5, 80.0}, "farthest echo");
  v.number("laser_noise", s.laser_noise_m, Unit::length, {0.0, 0.2}, "deviation of a reading");
  v.number("servo_speed", s.servo_speed_rad_s, Unit::turn_rate, {0.05, 20.0}, "of pan and tilt");
  v.number("camera_period", s.camera_period_s, Unit::duration, {0.02, 2.0},
           "from one image to the next");
  v.number("camera_latency", s.camera_latency_s, Unit::duration, {0.0, 2.0}, "from light to image");
}

/// What breaks on purpose. 0 s: never.
struct FaultSettings {
  double camera_stops_at_s = 0.0;    ///< no fault unless asked for
  double camera_returns_at_s = 0.0;  ///< no fault unless asked for
  double image_loss = 0.0;           ///< share of images that never come
  double command_loss = 0.0;         ///< share of commands that never come
  double link_stops_at_s = 0.0;      ///< no fault unless asked for
};

template <class V>
void visit(V& v, FaultSettings& s) {
  using config::Unit;
  v.number("camera_stops_at", s.camera_stops_at_s, Unit::duration, {0.0, 36000.0},
           "no new image from then on; 0 s: never");
  v.number("camera_returns_at", s.camera_returns_at_s, Unit::duration, {0.0, 36000.0},
           "images come again; 0 s: never");
  v.renamed("picture_loss", "image_loss");
  v.number("image_loss", s.image_loss, Unit::fraction, {0.0, 1.0}, "share of lost images");
  v.number("command_loss", s.command_loss, Unit::fraction, {0.0, 1.0}, "share of lost commands");
  v.number("link_stops_at", s.link_stops_at_s, Unit::duration, {0.0, 36000.0},
           "no command arrives from then on; 0 s: never");
}

/// When a run is over: then sense() says false.
struct JudgeSettings {
  bool ends_at_collision = true;  ///< the bumper ends the run, as in the paper
  bool ends_at_goal = true;
  double time_limit_s = 1200.0;  ///< 0 s: none
};

template <class V>
void visit(V& v, JudgeSettings& s) {
  v.flag("ends_at_collision", s.ends_at_collision, "the bumper ends the run");
  v.flag("ends_at_goal", s.ends_at_goal, "passing the goal line ends the run");
  v.number("time_limit", s.time_limit_s, config::Unit::duration, {0.0, 36000.0},
           "longest run; 0 s: no limit");
}

struct SimulatorSettings {
  BaseSettings base;
  SensorSettings sensors;
  FaultSettings faults;
  JudgeSettings judge;
};

template <class V>
void visit(V& v, SimulatorSettings& s) {
  v.section("base", s.base);
  v.section("sensors", s.sensors);
  v.section("faults", s.faults);
  v.section("judge", s.judge);
}

}  // namespace striate::simulator
