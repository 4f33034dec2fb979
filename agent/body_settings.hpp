#pragma once

#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::agent {

/// The robot's shape seen from above, from the middle of its wheel axle. Defaults: Pioneer 3-DX.
struct OutlineSettings {
  double front_m = RobotDescription{}.front_m;
  double rear_m = RobotDescription{}.rear_m;
  double half_width_m = RobotDescription{}.half_width_m;
  double corner_m = RobotDescription{}.corner_m;
};

template <class V>
void visit(V& v, OutlineSettings& s) {
  using config::Unit;
  v.number("front", s.front_m, Unit::length, {0.05, 1.0}, "from the axle to the front end");
  v.number("rear", s.rear_m, Unit::length, {0.05, 1.0}, "from the axle to the rear end");
  v.number("half_width", s.half_width_m, Unit::length, {0.05, 0.6}, "from the middle to a flank");
  v.number("corner", s.corner_m, Unit::length, {0.0, 0.5},
           "of the slanted sides that cut the four corners; shortened where they would meet");
}

/// The body: outline and limits. A real robot goes no faster than its base allows either.
struct BodySettings {
  OutlineSettings outline;
  double max_forward_m_s = RobotDescription{}.max_forward_m_s;
  double max_turn_rad_s = RobotDescription{}.max_turn_rad_s;
  double max_acceleration_m_s2 = RobotDescription{}.max_acceleration_m_s2;
  double max_turn_acceleration_rad_s2 = RobotDescription{}.max_turn_acceleration_rad_s2;
  double max_pan_rad = RobotDescription{}.max_pan_rad;
  double max_tilt_rad = RobotDescription{}.max_tilt_rad;
};

template <class V>
void visit(V& v, BodySettings& s) {
  using config::Unit;
  v.section("outline", s.outline);
  v.number("max_forward", s.max_forward_m_s, Unit::speed, {0.05, 2.2}, "fastest, either way");
  v.number("max_turn", s.max_turn_rad_s, Unit::turn_rate, {0.1, 8.0}, "fastest turn");
  v.number("max_acceleration", s.max_acceleration_m_s2, Unit::acceleration, {0.05, 5.0},
           "also the deceleration that a stop counts on");
  v.number("max_turn_acceleration", s.max_turn_acceleration_rad_s2, Unit::turn_acceleration,
           {0.1, 20.0}, "of turning");
  v.number("max_pan", s.max_pan_rad, Unit::angle, {0.0, 2.6}, "of the head, to either side");
  v.number("max_tilt", s.max_tilt_rad, Unit::angle, {0.0, 1.5}, "of the head, up and down");
}

/// The part of a description that these settings say; the camera is for others to say.
[[nodiscard]] RobotDescription described_by(const BodySettings& settings);

}  // namespace striate::agent
