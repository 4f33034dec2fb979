#include <cmath>

#include "striate/base/stopping_speed.hpp"
#include "striate/platform/pioneer/keeper/line_keeper.hpp"
#include "striate/platform/pioneer/safety_gate.hpp"

namespace striate::pioneer {
namespace {

/// A program that was not scheduled for this long has left the robot alone: that is a gap.
constexpr Duration kMissedTicks = std::chrono::milliseconds(300);
/// What was late is fresh again when it has been so for five cycles: no stuttering
constexpr Duration kCalm = std::chrono::milliseconds(500);
/// Five SIPs: by then the flags of one would show that they are on
constexpr Duration kAskMotorsAgain = std::chrono::milliseconds(500);

}  // namespace

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
      session_.send(arcos::command(arcos::Command::enable, 1));
      motors_asked_ = true;
      motors_asked_at_ = now;
    }
    motors_were_on_ = motors_were_on_ || base.motors_on;
  } else if (base.motors_on && standing && ask_again) {
    session_.send(arcos::command(arcos::Command::enable, 0));
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

}  // namespace striate::pioneer
