#include "striate/platform/pioneer/safety_gate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "striate/base/stopping_speed.hpp"
#include "striate/platform/pioneer/keeper/line_keeper.hpp"

namespace striate::pioneer {

using arcos::Command;

namespace {

/// A program that was not scheduled for this long has left the robot alone: that is a gap.
constexpr Duration kMissedTicks = std::chrono::milliseconds(300);
/// What was late is fresh again when it has been so for five cycles: no stuttering
constexpr Duration kCalm = std::chrono::milliseconds(500);
/// Five SIPs: by then the flags of one would show that they are on
constexpr Duration kAskMotorsAgain = std::chrono::milliseconds(500);
/// The head's thread speaks every few milliseconds.
constexpr Duration kHeadSilent = std::chrono::milliseconds(500);
/// Those that look within 30 deg of straight ahead (robot_model.cpp)
constexpr std::array<std::size_t, 4> kFrontDiscs{2, 3, 4, 5};
/// Those that look within 30 deg of straight behind (robot_model.cpp)
constexpr std::array<std::size_t, 4> kRearDiscs{10, 11, 12, 13};
/// Slower is standing: ten times the resolution of a SIP's wheel speeds
constexpr double kCreepsMm_s = 10.0;
/// Of the brake that the gate counts on; less where the robot was told less.
constexpr double kMostBrakeMm_s2 = 300.0;
/// While the robot moves; the line's keeper must hear the mind before its lease ends, also when one
/// word comes late (keeper/line_keeper.hpp)
constexpr Duration kSayAgainWithin = kMindLease * 2 / 5;

}  // namespace

void SafetyGate::command(const MotorCommand& command, TimePoint given_at,
                         std::optional<TimePoint> seen_at) {
  if (moved_at_ && given_at - *moved_at_ > from_seconds(settings_.command_gap_s)) {
    latch(HoldReason::stopped, given_at);
  }
  command_ = command;
  // What is no number must not become a speed.
  if (!std::isfinite(command.forward_m_s) || !std::isfinite(command.turn_rad_s)) {
    command_.forward_m_s = 0.0;
    command_.turn_rad_s = 0.0;
  }
  given_at_ = given_at;
  given_ = true;
  seen_at_ = seen_at;
  moved_at_.reset();
  if (command_.forward_m_s != 0.0 || command_.turn_rad_s != 0.0) moved_at_ = given_at;
}

void SafetyGate::gap(TimePoint now) {
  not_before_ = now;
  given_ = given_ && given_at_ > now;
}

void SafetyGate::latch(HoldReason why, TimePoint now) {
  if (latch_ < why) latch_ = why;
  gap(now);
}

void SafetyGate::emergency_stop(TimePoint now) {
  latch(HoldReason::emergency, now);
  motors_wanted_ = false;
  if (session_.state() != LinkState::ready) return;
  session_.send(arcos::command(Command::emergency_stop));
  send_stop(now);
}

void SafetyGate::reset(TimePoint now) {
  latch_ = HoldReason::none;
  motors_wanted_ = true;
  motors_were_on_ = false;
  motors_asked_ = false;
  moved_at_.reset();
  gap(now);
}

void SafetyGate::watch_joystick(TimePoint now) {
  if (!session_.base().joystick_pressed) return;
  const bool first = latch_ < HoldReason::joystick;
  latch(HoldReason::joystick, now);
  // A robot that does not let the hand drive would keep its speed.
  if (first) send_stop(now);
}

void SafetyGate::watch_motors(TimePoint now) {
  const BaseState& base = session_.base();
  if (base.stop_pressed && latch_ != HoldReason::emergency) emergency_stop(now);
  const bool standing = std::abs(base.odometry.forward_m_s) < kCreepsMm_s / 1000.0;
  const bool ask_again = !motors_asked_ || now - motors_asked_at_ >= kAskMotorsAgain;
  if (motors_wanted_) {
    if (motors_were_on_ && !base.motors_on) {
      motors_wanted_ = false;
      latch(HoldReason::motors_off, now);
    } else if (!base.motors_on && ask_again && latch_ == HoldReason::none) {
      session_.send(arcos::command(Command::enable, 1));
      motors_asked_ = true;
      motors_asked_at_ = now;
    }
    motors_were_on_ = motors_were_on_ || base.motors_on;
  } else if (base.motors_on && standing && ask_again) {
    session_.send(arcos::command(Command::enable, 0));
    motors_asked_ = true;
    motors_asked_at_ = now;
  }
}

void SafetyGate::watch_the_ticks(TimePoint now) {
  const Duration since = ticked_ ? now - last_tick_ : Duration{};
  missed_ = since > kMissedTicks;
  // Whoever stopped the program may stand before the robot by now.
  if (was_ready_ && since > from_seconds(settings_.longest_gap_s)) latch(HoldReason::stopped, now);
  ticked_ = true;
  last_tick_ = now;
}

/// A command is as old at the wheels as what it was decided by, and the way there.
void SafetyGate::watch_lateness(TimePoint now) {
  const Duration delay =
      session_.measures_the_line() ? session_.line_delay(now).value_or(Duration{}) : Duration{};
  if (delay > from_seconds(settings_.line_late_s)) line_late_until_ = now + kCalm;
  const bool old =
      given_ && seen_at_ && now - *seen_at_ + delay > from_seconds(settings_.seen_old_s);
  if (old) seen_old_until_ = now + kCalm;
}

void SafetyGate::watch(TimePoint now) {
  watch_the_ticks(now);
  const bool ready = session_.state() == LinkState::ready;
  if (was_ready_ && !ready) latch(HoldReason::link_lost, now);
  if (ready && !was_ready_) {
    // Whoever drove the robot before: it stands first.
    gap(now);
    motors_were_on_ = motors_asked_ = silent_ = false;
    send_stop(now);
  }
  was_ready_ = ready;
  if (!ready) return;
  // By what the robot says of itself: a laser in the same line tells nothing of bumpers.
  const bool silent = now - session_.last_state() > from_seconds(settings_.silence_s);
  if (silent || silent_ || missed_) gap(now);
  if ((silent && !silent_) || (silent_ && !silent) || missed_) send_stop(now);
  silent_ = silent;
  if (silent) return;
  watch_lateness(now);
  watch_joystick(now);
  watch_motors(now);
}

double SafetyGate::free_way_mm_s(bool forward, TimePoint now) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const std::size_t disc : forward ? kFrontDiscs : kRearDiscs) {
    const DiscReading& reading = session_.base().sonar[disc];
    if (reading.told && now - reading.stamp < kSonarFresh) {
      nearest_m = std::min(nearest_m, reading.range_m);
    }
  }
  const double way_mm = 1000.0 * std::max(0.0, nearest_m - settings_.sonar_stop_m);
  if (!std::isfinite(way_mm)) return way_mm;
  const double brake = std::min(kMostBrakeMm_s2, session_.deceleration_mm_s2());
  return stopping_speed(way_mm, brake, settings_.latency_s);
}

void SafetyGate::limit_by_sonar(Motion& motion, TimePoint now) {
  if (!settings_.sonar || motion.forward_mm_s == 0.0) return;
  const double most = free_way_mm_s(motion.forward_mm_s > 0.0, now);
  if (most >= std::abs(motion.forward_mm_s)) return;
  reason_ = most < kCreepsMm_s ? HoldReason::obstacle : HoldReason::slowed;
  motion.forward_mm_s = most < kCreepsMm_s ? 0.0 : std::copysign(most, motion.forward_mm_s);
}

void SafetyGate::limit_by_touch(Motion& motion, TimePoint now) {
  const BaseState& base = session_.base();
  if ((base.stalled_left || base.stalled_right) && sent_forward_mm_s_ != 0) {
    blocked_sign_ = sent_forward_mm_s_ > 0 ? 1.0 : -1.0;
    blocked_until_ = now + from_seconds(settings_.stall_pause_s);
  }
  if (now < blocked_until_ && motion.forward_mm_s * blocked_sign_ > 0.0) {
    motion = {};
    reason_ = HoldReason::stalled;
  }
  if ((base.bumper_front && motion.forward_mm_s > 0.0) ||
      (base.bumper_rear && motion.forward_mm_s < 0.0)) {
    motion = {};
    reason_ = HoldReason::bumper;
  }
}

bool SafetyGate::line_is_late(TimePoint now) const {
  const bool unknown = session_.measures_the_line() && !session_.line_delay(now);
  return unknown || now < line_late_until_;
}

bool SafetyGate::laser_is_stale(TimePoint now) const {
  const Duration longest = from_seconds(settings_.laser_stale_s);
  const RangeScan& laser = session_.base().laser;
  if (!laser.readings.empty() && now - laser.stamp > longest) return true;
  return laser_at_ && now - *laser_at_ > longest;
}

bool SafetyGate::head_fails(TimePoint now) const {
  return !head_ok_ || (head_told_at_ && now - *head_told_at_ > kHeadSilent);
}

SafetyGate::Motion SafetyGate::allowed(TimePoint now) {
  reason_ = HoldReason::none;
  if (latch_ != HoldReason::none) {
    reason_ = latch_;
  } else if (session_.state() != LinkState::ready) {
    reason_ = HoldReason::not_ready;
  } else if (silent_) {
    reason_ = HoldReason::robot_silent;
  } else if (!given_ || given_at_ <= not_before_) {
    reason_ = HoldReason::no_command;
  } else if (now - given_at_ > from_seconds(settings_.command_lease_s)) {
    reason_ = HoldReason::command_old;
  } else if (line_is_late(now)) {
    reason_ = HoldReason::line_late;
  } else if (now < seen_old_until_) {
    reason_ = HoldReason::seen_old;
  } else if (session_.base().battery_v < settings_.battery_stop_v) {
    reason_ = HoldReason::battery_low;
  } else if (laser_is_stale(now)) {
    reason_ = HoldReason::laser_stale;
  } else if (head_fails(now)) {
    reason_ = HoldReason::head_fails;
  }
  if (reason_ != HoldReason::none) return {};
  Motion motion{1000.0 * command_.forward_m_s, degrees(command_.turn_rad_s)};
  motion.forward_mm_s =
      std::clamp(motion.forward_mm_s, -session_.most_forward_mm_s(), session_.most_forward_mm_s());
  motion.turn_deg_s =
      std::clamp(motion.turn_deg_s, -session_.most_turn_deg_s(), session_.most_turn_deg_s());
  limit_by_sonar(motion, now);
  limit_by_touch(motion, now);
  return motion;
}

void SafetyGate::send_stop(TimePoint now) {
  sent_ = false;
  send({}, now);
}

void SafetyGate::send(const Motion& motion, TimePoint now) {
  const int forward = static_cast<int>(std::lround(motion.forward_mm_s));
  const int turn = static_cast<int>(std::lround(motion.turn_deg_s));
  const bool same = sent_ && forward == sent_forward_mm_s_ && turn == sent_turn_deg_s_;
  Duration again = from_seconds(settings_.send_every_s);
  if (forward != 0 || turn != 0) again = std::min(again, kSayAgainWithin);
  if (same && now - sent_at_ < again) return;
  session_.send(arcos::command(Command::velocity, forward));
  session_.send(arcos::command(Command::rotation_velocity, turn));
  sent_forward_mm_s_ = forward;
  sent_turn_deg_s_ = turn;
  sent_ = true;
  sent_at_ = now;
}

void SafetyGate::tick(TimePoint now) {
  watch(now);
  const Motion motion = allowed(now);
  if (session_.state() != LinkState::ready) return;
  if (session_.base().joystick_pressed && !silent_ && latch_ == HoldReason::joystick) {
    // The hand drives: only a sign of life, no speeds.
    if (now - sent_at_ >= from_seconds(settings_.send_every_s)) {
      session_.send(arcos::command(Command::pulse));
      sent_forward_mm_s_ = sent_turn_deg_s_ = 0;
      sent_ = false;  // when it lets go, the stop is sent at once
      sent_at_ = now;
    }
    return;
  }
  send(motion, now);
}

}  // namespace striate::pioneer
