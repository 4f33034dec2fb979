#pragma once

#include <optional>

#include "striate/platform/interface/motor_command.hpp"
#include "striate/platform/pioneer/hold_reason.hpp"
#include "striate/platform/pioneer/safety_gate_settings.hpp"
#include "striate/platform/pioneer/session.hpp"

namespace striate::pioneer {

/// The only sender of motion. Every few 10 ms it decides from the newest command, its age, and what
/// the robot says, and sends forward and turning speed. Pure: times are injected.
///
/// Nothing drives that is older than its lease. After any gap (the robot was silent, this program
/// was not scheduled) the first thing sent is a stop, because the firmware resumes the old motion,
/// and only a command given after the gap drives again. Where the program did not run for longer,
/// or nobody commanded in the midst of motion, `reset` is needed; also after a broken link, an
/// emergency stop, the joystick or motors that went off. Age is counted at the wheels: what the
/// line takes there and back belongs to it.
class SafetyGate {
 public:
  SafetyGate(const SafetyGateSettings& settings, ArcosSession& session)
      : settings_(settings), session_(session) {}

  /// What is wanted until the lease ends.
  /// @param given_at when it was decided
  /// @param seen_at when the image was taken that it was decided by; nothing: by none
  void command(const MotorCommand& command, TimePoint given_at,
               std::optional<TimePoint> seen_at = std::nullopt);
  /// Stands at once and stays so until `reset`.
  void emergency_stop(TimePoint now);
  /// Ends what is latched, switches the motors on, and waits for a newer command.
  void reset(TimePoint now);

  /// A head that is stuck, silent or overloaded may look anywhere: then the robot stands, and also
  /// where this has been said once and is not said again.
  void set_head_ok(bool ok, TimePoint now) {
    head_ok_ = ok;
    head_told_at_ = now;
  }
  /// A laser on a line of its own has measured; when it falls silent the robot stands.
  void laser_has_measured(TimePoint stamp) { laser_at_ = stamp; }

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
  void watch_the_ticks(TimePoint now);
  void watch_lateness(TimePoint now);
  [[nodiscard]] bool line_is_late(TimePoint now) const;
  [[nodiscard]] bool laser_is_stale(TimePoint now) const;
  [[nodiscard]] bool head_fails(TimePoint now) const;
  [[nodiscard]] Motion allowed(TimePoint now);
  void limit_by_touch(Motion& motion, TimePoint now);
  void limit_by_sonar(Motion& motion, TimePoint now);
  [[nodiscard]] double free_way_mm_s(bool forward, TimePoint now) const;
  void send(const Motion& motion, TimePoint now);
  void send_stop(TimePoint now);

  /// Slower is standing: ten times the resolution of a SIP's wheel speeds
  static constexpr double kCreepsMm_s = 10.0;

  SafetyGateSettings settings_;
  ArcosSession& session_;
  MotorCommand command_;
  TimePoint given_at_;
  bool given_ = false;
  std::optional<TimePoint> seen_at_;
  std::optional<TimePoint> moved_at_;  ///< the last command, where it was motion
  TimePoint not_before_;               ///< commands given earlier do not drive
  HoldReason reason_ = HoldReason::not_ready;
  HoldReason latch_ = HoldReason::none;

  bool ticked_ = false;
  TimePoint last_tick_;
  bool was_ready_ = false;
  bool silent_ = false;
  bool missed_ = false;        ///< the newest tick came late
  TimePoint line_late_until_;  ///< late, and some time after
  TimePoint seen_old_until_;
  bool head_ok_ = true;
  std::optional<TimePoint> head_told_at_;  ///< empty: there is no head
  std::optional<TimePoint> laser_at_;      ///< empty: there is no laser, or it has not spoken
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
