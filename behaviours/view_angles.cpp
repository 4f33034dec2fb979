#include "striate/behaviours/view_angles.hpp"

#include <algorithm>
#include <cmath>

namespace striate::behaviours {
namespace {

constexpr double kPioneerPan_rad = 0.16;
constexpr double kLaneSeen_m = 1.0;

/// Half the vertical angle; images are 4:3.
double half_upright_rad(const RobotDescription& robot) {
  return std::atan(0.75 * std::tan(0.5 * robot.view_rad));
}

double spare_beside_lane_rad(const RobotDescription& robot) {
  return 0.5 * robot.view_rad - std::atan(robot.half_width_m / kLaneSeen_m);
}

}  // namespace

double same_floor_tilt(const RobotDescription& robot, double pioneer_tilt_rad) {
  const RobotDescription pioneer;
  const double lowest_rad = half_upright_rad(pioneer) - pioneer_tilt_rad;
  const double from_m = pioneer.camera_height_m / std::tan(lowest_rad);
  const auto tilt_rad = [from_m](const RobotDescription& body) {
    return half_upright_rad(body) - std::atan2(body.camera_height_m, from_m);
  };
  return pioneer_tilt_rad + (tilt_rad(robot) - tilt_rad(pioneer));
}

double pan_while_driving(const RobotDescription& robot) {
  const double more_rad = spare_beside_lane_rad(robot) - spare_beside_lane_rad(RobotDescription{});
  return std::max(0.0, kPioneerPan_rad + more_rad);
}

}  // namespace striate::behaviours
