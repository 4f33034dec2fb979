#pragma once

#include <string>

#include "striate/base/pioneer_devices.hpp"

namespace striate::pioneer {

/// What the numbers of a kind of robot mean. The kind is the subclass that the robot tells at the
/// end of the handshake; the wrong one gives wrong odometry, so an unknown kind is refused.
struct RobotModel {
  std::string subclass;
  double distance_mm = 1.0;              ///< of one count of x and y
  double angle_rad = kHeadingCount_rad;  ///< of one count of the heading
  double range_mm = 1.0;                 ///< of one count of sonar
  double half_axle_mm = 178.6;           ///< from wheel speeds to turning
  double most_forward_mm_s = 2200.0;
  double most_turn_deg_s = 500.0;
};

/// The kind that a subclass names, with or without the laser that it carries ("p3dx-sh-lms1xx").
/// Null: unknown.
[[nodiscard]] const RobotModel* find_model(const std::string& subclass);
/// "p3dx, p3dx-sh"
[[nodiscard]] std::string known_models();

}  // namespace striate::pioneer
