#pragma once

#include <array>

#include "striate/base/geometry.hpp"

namespace striate::memory {

/// Row-major covariance of a pose: x, y, heading.
using PoseCovariance = std::array<double, 9>;

/// A landmark that was seen without a range.
struct SeenBearing {
  Pose2 from;  ///< the camera's base at the image's moment, in the robot's frame now
  double bearing_rad = 0.0;
  double sigma_rad = 0.0;
};

namespace slam_state {
constexpr int kLandmarks = 128;  ///< by hand: a covariance of 262 x 262, 0.55 MB
constexpr int kRobot = 6;        ///< states: pose and the three errors of its odometry
}  // namespace slam_state

}  // namespace striate::memory
