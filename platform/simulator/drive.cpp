#include "striate/platform/simulator/drive.hpp"

#include <algorithm>
#include <cmath>

namespace striate::simulator {
namespace {

/// Steps that end within a nanosecond of a due time are there: sums of 10 ms are not exact.
constexpr double kAlmostThere_s = 1e-9;
/// Slower than this the wheels cannot be told from standing.
/// Slower than this the wheels cannot be told from standing: 20 times a SIP's 1 mm/s
constexpr double kStanding_m_s = 0.02;
constexpr double kStandingRad_s = 0.05;  // 3 deg/s: slower turning cannot be told from standing

/// Share of the wanted speed: held wheels go slower; slip and ramps do not halve it (ours)
constexpr double kHeld = 0.5;

double towards(double value, double goal, double largest_change) {
  return value + std::clamp(goal - value, -largest_change, largest_change);
}

}  // namespace

void Drive::command(double now_s, const MotorCommand& command) {
  MotorCommand sane = command;
  // What is no number must not become a speed: it stops the wheels.
  if (!std::isfinite(sane.forward_m_s) || !std::isfinite(sane.turn_rad_s)) {
    sane.forward_m_s = 0.0;
    sane.turn_rad_s = 0.0;
  }
  pending_.push_back({now_s + settings_.command_latency_s, sane});
}

void Drive::stop() {
  pending_.clear();
  in_force_.forward_m_s = 0.0;
  in_force_.turn_rad_s = 0.0;
}

void Drive::step(double now_s, double dt_s, double really_forward_m_s, double really_turn_rad_s) {
  while (!pending_.empty() && pending_.front().due_s <= now_s + kAlmostThere_s) {
    in_force_ = pending_.front().command;
    last_arrival_s_ = now_s;
    pending_.pop_front();
  }
  if (now_s - last_arrival_s_ > settings_.watchdog_s) {
    in_force_.forward_m_s = 0.0;
    in_force_.turn_rad_s = 0.0;
  }
  feel_stall(dt_s, really_forward_m_s, really_turn_rad_s);
  const double forward =
      std::clamp(in_force_.forward_m_s, -robot_.max_forward_m_s, robot_.max_forward_m_s);
  const double turn =
      std::clamp(in_force_.turn_rad_s, -robot_.max_turn_rad_s, robot_.max_turn_rad_s);
  forward_m_s_ = towards(forward_m_s_, forward, robot_.max_acceleration_m_s2 * dt_s);
  turn_rad_s_ = towards(turn_rad_s_, turn, robot_.max_turn_acceleration_rad_s2 * dt_s);
}

void Drive::feel_stall(double dt_s, double really_forward_m_s, double really_turn_rad_s) {
  const bool held_forward = std::abs(forward_m_s_) > kStanding_m_s &&
                            std::abs(really_forward_m_s) < kHeld * std::abs(forward_m_s_);
  const bool held_turn = std::abs(turn_rad_s_) > kStandingRad_s &&
                         std::abs(really_turn_rad_s) < kHeld * std::abs(turn_rad_s_);
  if (!held_forward && !held_turn) {
    pushing_s_ = 0.0;
    stalled_ = false;
    return;
  }
  pushing_s_ += dt_s;
  if (pushing_s_ + kAlmostThere_s < settings_.stall_after_s) return;
  // A blocked motor turns no further than the thing in its way lets it.
  stalled_ = true;
  forward_m_s_ = towards(really_forward_m_s, forward_m_s_, 2 * kStanding_m_s);
  turn_rad_s_ = towards(really_turn_rad_s, turn_rad_s_, 2 * kStandingRad_s);
}

}  // namespace striate::simulator
