#pragma once

#include <string>

#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::app {

/// Where the wheels of a recorded run say that the robot was: on the floor, z = 0, from where it
/// started. @throws UserError as the reader of recordings does
[[nodiscard]] datasets::Trajectory recorded_odometry(const std::string& recording);

/// A trajectory of any kind: a recording's odometry, or a file of TUM, KITTI or EuRoC.
/// @param times KITTI's; empty: none
[[nodiscard]] datasets::Trajectory read_estimate(const std::string& file, const std::string& times);

}  // namespace striate::app
