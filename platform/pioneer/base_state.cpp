#include "striate/platform/pioneer/base_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "striate/platform/interface/seen_from_axle.hpp"

namespace striate::pioneer {
namespace {

/// Of each byte of STALL AND BUMPERS; ARCOS manual, standard SIP
constexpr std::uint16_t kStallBit = 1U;
/// Of each byte of STALL AND BUMPERS: seven bumpers; ARCOS manual, standard SIP
constexpr std::uint16_t kBumperBits = 0xfeU;
/// Sonar calls 5 m "nothing"; simulators send up to this much and a little less.
constexpr double kNoEchoMm = 4995.0;

/// The difference of two counts that wrap at 2^15.
int wrapped_difference(std::uint16_t now, std::uint16_t before) {
  return ((now - before + 0x4000) & 0x7fff) - 0x4000;
}

}  // namespace

void BaseTracker::use_bumpers(bool front, bool rear) {
  front_bumper_ = front;
  rear_bumper_ = rear;
}

void BaseTracker::move_on(const arcos::Sip& sip) {
  Pose2& pose = state_.odometry.pose;
  const double heading_rad = sip.heading * model_.angle_rad;
  if (!seeded_) {
    // Paths are told in the robot's frame, whose heading now is its own.
    frame_turn_rad_ = wrap_angle(pose.heading_rad - heading_rad);
    seeded_ = true;
  } else {
    const double mm = model_.distance_mm / 1000.0;
    const Point2 way =
        transform({0.0, 0.0, frame_turn_rad_},
                  Point2{wrapped_difference(sip.x, x_) * mm, wrapped_difference(sip.y, y_) * mm});
    pose.x_m += way.x_m;
    pose.y_m += way.y_m;
    pose.heading_rad = wrap_angle(heading_rad + frame_turn_rad_);
  }
  x_ = sip.x;
  y_ = sip.y;
  heading_ = sip.heading;
}

void BaseTracker::take_laser(const std::vector<std::uint16_t>& ranges_mm, TimePoint stamp) {
  state_.laser.stamp = stamp;
  state_.laser.readings.clear();
  const double steps = std::max<double>(1.0, static_cast<double>(ranges_mm.size()) - 1.0);
  for (std::size_t i = 0; i < ranges_mm.size(); ++i) {
    const double bearing_rad = radians(-90.0 + 180.0 * static_cast<double>(i) / steps);
    state_.laser.readings.push_back(
        seen_from_axle({kLaserForward_m, 0.0, bearing_rad}, ranges_mm[i] / 1000.0));
  }
}

void BaseTracker::take(const arcos::Sip& sip, TimePoint stamp) {
  move_on(sip);
  state_.stamp = stamp;
  state_.told = true;
  state_.odometry.stamp = stamp;
  const double left_mm_s = sip.left_mm_s * model_.velocity_mm_s;
  const double right_mm_s = sip.right_mm_s * model_.velocity_mm_s;
  state_.odometry.forward_m_s = (left_mm_s + right_mm_s) / 2000.0;
  state_.odometry.turn_rad_s = sip.rotation_ddeg_s
                                   ? radians(*sip.rotation_ddeg_s / 10.0)
                                   : (right_mm_s - left_mm_s) / (2.0 * model_.half_axle_mm);
  for (const arcos::SonarReading& reading : sip.sonar) {
    if (reading.disc >= model_.discs.size()) continue;
    const double mm = reading.range * model_.range_mm;
    const double range_m = mm >= kNoEchoMm ? std::numeric_limits<double>::infinity() : mm / 1000.0;
    state_.sonar[reading.disc] = {stamp, range_m, true};
  }
  state_.battery_v = sip.battery_x10_dv.value_or(sip.battery_dv) / 10.0;
  const unsigned rear = sip.stall_and_bumpers & 0xffU;
  const unsigned front = sip.stall_and_bumpers >> 8U;
  state_.stalled_left = (rear & kStallBit) != 0;
  state_.stalled_right = (front & kStallBit) != 0;
  state_.bumper_rear = rear_bumper_ && (rear & kBumperBits) != 0;
  state_.bumper_front = front_bumper_ && (front & kBumperBits) != 0;
  state_.motors_on = (sip.flags & arcos::SipFlag::motors_on) != 0;
  state_.stop_pressed =
      (sip.flags & (arcos::SipFlag::stop_pressed | arcos::SipFlag::emergency_stall)) != 0;
  state_.joystick_pressed = (sip.flags & arcos::SipFlag::joystick_button) != 0;
}

}  // namespace striate::pioneer
