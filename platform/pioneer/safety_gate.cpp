#include "striate/platform/pioneer/safety_gate.hpp"

#include <algorithm>
#include <cmath>

#include "striate/platform/pioneer/keeper/line_keeper.hpp"

namespace striate::pioneer {
namespace {

/// While the robot moves; the line's keeper must hear the mind before its lease ends, also when one
/// word comes late (keeper/line_keeper.hpp)
constexpr Duration kSayAgainWithin = kMindLease * 2 / 5;

}  // namespace

using arcos::Command;

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
