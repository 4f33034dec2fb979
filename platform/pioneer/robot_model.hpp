#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "striate/base/pioneer_devices.hpp"

namespace striate::pioneer {

/// The most discs that a kind has: a PeopleBot's four arrays of eight.
inline constexpr std::size_t kMostSonarDiscs = 32;

/// What the numbers of a kind of robot mean, and where its sonar discs sit. The kind is the
/// subclass that the robot tells at the end of the handshake; the wrong one gives wrong odometry,
/// so an unknown kind is refused.
struct RobotModel {
  std::string subclass;
  double distance_mm = 1.0;              ///< of one count of x and y
  double angle_rad = kHeadingCount_rad;  ///< of one count of the heading
  double velocity_mm_s = 1.0;            ///< of one count of a wheel's speed
  double range_mm = 1.0;                 ///< of one count of sonar
  double half_axle_mm = 178.6;           ///< from wheel speeds to turning
  double most_forward_mm_s = 2200.0;
  double most_turn_deg_s = 500.0;
  /// From the middle of the axle; at most kMostSonarDiscs, and for the whole of the program.
  std::span<const Pose2> discs = sonar_discs();
};

/// The kind that a subclass names, with or without the laser that it carries ("p3dx-sh-lms1xx").
/// Null: unknown.
[[nodiscard]] const RobotModel* find_model(const std::string& subclass);
/// p3dx, p3dx-sh, ...
[[nodiscard]] std::vector<std::string> model_names();

}  // namespace striate::pioneer
