#pragma once

#include "striate/base/limits.hpp"
#include "striate/config/settings.hpp"

namespace striate::pioneer {

struct SafetyGateSettings {
  /// Five cycles at 10 Hz; at 0.75 m/s 0.4 m of driving blind. Never longer
  double command_lease_s = to_seconds(kCommandLease);
  /// As the lease: what drives is older by no more than that. Never longer
  double line_late_s = to_seconds(kCommandLease);
  double seen_old_s = to_seconds(kCommandLease);     ///< as SafetyLimiterSettings::image_stop_s
  double longest_gap_s = to_seconds(kCommandLease);  ///< a hundred ticks of the driver's thread
  double command_gap_s = 1.0;  ///< twice the lease: ten cycles that nobody decided in (ours)
  double silence_s = 0.3;      ///< three SIPs missed
  double send_every_s = 0.1;   ///< one SIP cycle; twenty times within the watchdog's 2 s
  double laser_stale_s = 0.5;  ///< five scans missed at 10 Hz
  /// The wheels have relaxed and a behaviour has had ten cycles to turn away (ours)
  double stall_pause_s = 1.0;
  bool sonar = true;
  double sonar_stop_m = 0.10;          ///< the nearest that a disc hears
  double latency_s = kBrakeLatency_s;  ///< one SIP cycle and half of the next
  /// Below LowBattery, 11 V, of a P3-DX's FLASH; 12 V lead cells are empty at 1.8 V each
  double battery_stop_v = kEmptyBattery_v;
};

template <class V>
void visit(V& v, SafetyGateSettings& s) {
  using config::Unit;
  v.number("command_lease", s.command_lease_s, Unit::duration, {0.05, 0.5},
           "an older command does not drive");
  v.number("line_late", s.line_late_s, Unit::duration, {0.05, 0.5},
           "stands while a question to the robot's controller and its answer take longer");
  v.number("seen_old", s.seen_old_s, Unit::duration, {0.1, 0.5},
           "a command does not drive when the image it was decided by, with the way to the robot, "
           "is older");
  v.number("longest_gap", s.longest_gap_s, Unit::duration, {0.3, 1.0},
           "after not running for so long, as when suspended, it stands until it is reset");
  v.number("command_gap", s.command_gap_s, Unit::duration, {0.5, 10.0},
           "without a command for so long in the midst of motion it stands until it is reset");
  v.number("silence", s.silence_s, Unit::duration, {0.15, 1.0},
           "without a packet from the robot for so long it is told to stand");
  v.number("send_every", s.send_every_s, Unit::duration, {0.02, 0.4},
           "a command is repeated, which is the sign of life, too");
  v.number("laser_stale", s.laser_stale_s, Unit::duration, {0.2, 5.0},
           "a laser that has spoken and is silent for so long stops the robot");
  v.number("stall_pause", s.stall_pause_s, Unit::duration, {0.0, 10.0},
           "after a stall no push the same way for so long");
  v.flag("sonar", s.sonar, "the front and rear discs may slow and stop the robot");
  v.number("sonar_stop", s.sonar_stop_m, Unit::length, {0.0, 0.5},
           "stands so far from an echo, measured from the disc");
  v.number("latency", s.latency_s, Unit::duration, {0.0, 1.0}, "from command to braking");
  v.number("battery_stop", s.battery_stop_v, Unit::none, {0.0, 60.0},
           "volts: below it the robot stands");
}

}  // namespace striate::pioneer
