#include "striate/agent/body_settings.hpp"

#include <algorithm>
#include <numbers>

namespace striate::agent {
namespace {

/// Slanted sides that leave a tenth of each straight one.
double fitting_corner_m(const OutlineSettings& outline) {
  const double least_m = std::min(outline.half_width_m, 0.5 * (outline.front_m + outline.rear_m));
  return std::min(outline.corner_m, 0.9 * least_m * std::numbers::sqrt2);
}

}  // namespace

RobotDescription described_by(const BodySettings& settings) {
  RobotDescription robot;
  robot.front_m = settings.outline.front_m;
  robot.rear_m = settings.outline.rear_m;
  robot.half_width_m = settings.outline.half_width_m;
  robot.corner_m = fitting_corner_m(settings.outline);
  robot.max_forward_m_s = settings.max_forward_m_s;
  robot.max_turn_rad_s = settings.max_turn_rad_s;
  robot.max_acceleration_m_s2 = settings.max_acceleration_m_s2;
  robot.max_turn_acceleration_rad_s2 = settings.max_turn_acceleration_rad_s2;
  robot.max_pan_rad = settings.max_pan_rad;
  robot.max_tilt_rad = settings.max_tilt_rad;
  return robot;
}

}  // namespace striate::agent
