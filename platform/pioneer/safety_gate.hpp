#pragma once

#include "config/settings.hpp"
#include "platform/interface/motor_command.hpp"
#include "platform/pioneer/hold_reason.hpp"
#include "platform/pioneer/session.hpp"

namespace striate::pioneer {

struct SafetyGateSettings {
  double command_lease_s = 0.5;
  double silence_s = 0.3;
  double send_every_s = 0.1;
  double laser_stale_s = 0.5;
  double stall_pause_s = 1.0;
  bool sonar = true;
  double sonar_stop_m = 0.10;
  double latency_s = 0.15;
  double battery_stop_v = 10.8;
};

template <class V>
void visit(V& v, SafetyGateSettings& s) {
  using config::Unit;
  v.number("command_lease", s.command_lease_s, Unit::duration, {0.05, 0.5},
           "an older command does not drive");
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

/// The only sender of motion. Every few 10 ms it decides from the newest command, its age, and what
/// the robot says, and sends forward and turning speed. Pure: times are injected.
///
/// Nothing drives that is older than its lease. After any gap (the robot was silent, this program
/// was not scheduled) the first thing sent is a stop, because the firmware resumes the old motion,
/// and only a command given after the gap drives again. After a broken link, an emergency stop, the
/// joystick or motors that went off, `reset` is needed.
class SafetyGate {
 public:
  SafetyGate(const SafetyGateSettings& settings, Session& session)
      : settings_(settings), session_(session) {}

  /// What is wanted until the lease ends. `given_at` is when it was decided.
  void command(const MotorCommand& command, TimePoint given_at);
  /// Stands at once and stays so until `reset`.
  void emergency_stop(TimePoint now);
  /// Ends what is latched, switches the motors on, and waits for a newer command.
  void reset(TimePoint now);

  /// A head that is stuck, silent or overloaded may look anywhere: then the robot stands.
  void set_head_ok(bool ok) { head_ok_ = ok; }

  void tick(TimePoint now);

  [[nodiscard]] HoldReason reason() const { return reason_; }
  [[nodiscard]] bool latched() const { return latch_ != HoldReason::none; }
  /// What was sent last.
  [[nodiscard]] int sent_forward_mm_s() const { return sent_forward_mm_s_; }
  [[nodiscard]] int sent_turn_deg_s() const { return sent_turn_deg_s_; }

 private:
  struct Motion {
    double forward_mm_s = 0.0;
    double turn_deg_s = 0.0;
  };
  void watch(TimePoint now);
  void watch_motors(TimePoint now);
  void watch_joystick(TimePoint now);
  void latch(HoldReason why, TimePoint now);
  void gap(TimePoint now);
  [[nodiscard]] bool laser_is_stale(TimePoint now) const;
  [[nodiscard]] Motion allowed(TimePoint now);
  void limit_by_touch(Motion& motion, TimePoint now);
  void limit_by_sonar(Motion& motion, TimePoint now);
  [[nodiscard]] double free_way_mm_s(bool forward, TimePoint now) const;
  void send(const Motion& motion, TimePoint now);
  void send_stop(TimePoint now);

  SafetyGateSettings settings_;
  Session& session_;
  MotorCommand command_;
  TimePoint given_at_;
  bool given_ = false;
  TimePoint not_before_;  ///< commands given earlier do not drive
  HoldReason reason_ = HoldReason::not_ready;
  HoldReason latch_ = HoldReason::none;

  bool ticked_ = false;
  TimePoint last_tick_;
  bool was_ready_ = false;
  bool silent_ = false;
  bool head_ok_ = true;
  bool motors_wanted_ = true;
  bool motors_were_on_ = false;
  TimePoint motors_asked_at_;
  bool motors_asked_ = false;
  double blocked_sign_ = 0.0;  ///< the way that a stall forbids
  TimePoint blocked_until_;

  int sent_forward_mm_s_ = 0;
  int sent_turn_deg_s_ = 0;
  bool sent_ = false;
  TimePoint sent_at_;
};

}  // namespace striate::pioneer
