#include "striate/platform/pioneer/firmware/wheel_control.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/stopping_speed.hpp"

namespace striate::pioneer {
namespace {

/// TransAccTop of a real P3-DX: no deceleration that it takes is harder
constexpr double kEmergencyMm_s2 = 2000.0;
/// Twice RotAccTop of a real P3-DX, 300: turning ends with the driving (ours)
constexpr double kEmergencyDeg_s2 = 600.0;
constexpr double kThereMm = 1.0;    // a MOVE is done: the resolution of a SIP's position
constexpr double kThere_deg = 0.3;  // a HEAD is done: three steps of a SIP's heading (0.088 deg)

double ramp(double now, double wanted, double up, double down) {
  // Speeding up is away from standing; changing sign passes through standing first.
  const bool faster = std::abs(wanted) > std::abs(now) && now * wanted >= 0.0;
  const double most = faster ? up : down;
  return now + std::clamp(wanted - now, -most, most);
}

/// The fastest from which it still stands after `way`.
double towards(double way, double fastest, double deceleration) {
  return std::copysign(std::min(fastest, stopping_speed(std::abs(way), deceleration, 0.0)), way);
}

}  // namespace

void WheelControl::set_forward(double mm_s) {
  way_left_mm_.reset();
  set_forward_mm_s_ = mm_s;
}

void WheelControl::set_turn(double deg_s) {
  heading_deg_.reset();
  set_turn_deg_s_ = deg_s;
}

void WheelControl::set_wheels(double left_mm_s, double right_mm_s, double half_axle_mm) {
  set_forward((left_mm_s + right_mm_s) / 2.0);
  set_turn((right_mm_s - left_mm_s) / (2.0 * half_axle_mm) * 57.29577951308232);
}

void WheelControl::move(double mm) {
  set_forward(0.0);
  way_left_mm_ = mm;
}

void WheelControl::head_for(double heading_deg) {
  set_turn(0.0);
  heading_deg_ = heading_deg;
}

void WheelControl::turn_on(double deg, double heading_deg) {
  head_for(heading_deg_.value_or(heading_deg) + deg);
}

void WheelControl::stop() {
  set_forward(0.0);
  set_turn(0.0);
}

void WheelControl::emergency_stop() {
  stop();
  emergency_ = true;
}

void WheelControl::release() {
  stop();
  forward_mm_s_ = 0.0;
  turn_deg_s_ = 0.0;
  emergency_ = false;
}

bool WheelControl::wants_to_stand() const {
  if (held_ || emergency_) return true;
  return set_forward_mm_s_ == 0.0 && set_turn_deg_s_ == 0.0 && !way_left_mm_ && !heading_deg_;
}

double WheelControl::wanted_forward(double dt_s) {
  if (!way_left_mm_) {
    return std::clamp(set_forward_mm_s_, -limits_.forward_mm_s, limits_.forward_mm_s);
  }
  *way_left_mm_ -= forward_mm_s_ * dt_s;
  if (std::abs(*way_left_mm_) < kThereMm) {
    way_left_mm_.reset();
    return 0.0;
  }
  return towards(*way_left_mm_, limits_.forward_mm_s, limits_.deceleration_mm_s2);
}

double WheelControl::wanted_turn(double heading_deg) {
  if (!heading_deg_) return std::clamp(set_turn_deg_s_, -limits_.turn_deg_s, limits_.turn_deg_s);
  const double left_deg = std::remainder(*heading_deg_ - heading_deg, 360.0);
  if (std::abs(left_deg) < kThere_deg) return 0.0;  // the heading is held from then on
  return towards(left_deg, limits_.turn_deg_s, limits_.turn_deceleration_deg_s2);
}

void WheelControl::step(double dt_s, double heading_deg) {
  const bool stands = held_ || emergency_;
  const double forward = stands ? 0.0 : wanted_forward(dt_s);
  const double turn = stands ? 0.0 : wanted_turn(heading_deg);
  const double brake = emergency_ ? kEmergencyMm_s2 : limits_.deceleration_mm_s2;
  const double turn_brake = emergency_ ? kEmergencyDeg_s2 : limits_.turn_deceleration_deg_s2;
  forward_mm_s_ = ramp(forward_mm_s_, forward, limits_.acceleration_mm_s2 * dt_s, brake * dt_s);
  turn_deg_s_ = ramp(turn_deg_s_, turn, limits_.turn_acceleration_deg_s2 * dt_s, turn_brake * dt_s);
  if (emergency_ && forward_mm_s_ == 0.0 && turn_deg_s_ == 0.0) emergency_ = false;
}

}  // namespace striate::pioneer
