#pragma once

#include <memory>

#include "striate/agent/body.hpp"
#include "striate/platform/rosbridge/rosbridge_robot.hpp"

namespace striate::agent {

/// The robot behind the rosbridge server that the settings name, with the camera of
/// `pioneer.devices.camera` where that is set, else with images that come as topics. Its camera
/// looks where `resting_tilt` says, unless `rosbridge.fixed_tilt` says otherwise.
/// @param patience how long it is waited for
/// @throws UserError, std::runtime_error, see rosbridge::RosbridgeRobot
[[nodiscard]] std::unique_ptr<rosbridge::RosbridgeRobot> join_rosbridge(
    const RobotSettings& settings, Duration patience = std::chrono::seconds(10));

/// The same for a mission, when it is woken.
[[nodiscard]] BodySource robot_behind_rosbridge();

}  // namespace striate::agent
