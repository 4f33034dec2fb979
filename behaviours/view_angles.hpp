#pragma once

#include "striate/platform/interface/robot.hpp"

/// Head angles were found by trials with the Pioneer's camera. These carry them over to a camera
/// that sees a wider or narrower angle, or is mounted higher or lower; for the Pioneer's own they
/// are the same to the last bit.
namespace striate::behaviours {

/// The tilt at which the robot's camera sees the floor from as near as the Pioneer's does at
/// `pioneer_tilt_rad` (below the horizon by more than 17 degrees less the half view, < 0). Up
/// positive; not limited to what the head can do.
[[nodiscard]] double same_floor_tilt(const RobotDescription& robot, double pioneer_tilt_rad);

/// How far the head may turn aside while the robot drives, >= 0: both flanks of its lane, a metre
/// on, stay in view.
[[nodiscard]] double pan_while_driving(const RobotDescription& robot);

}  // namespace striate::behaviours
