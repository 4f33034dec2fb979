#pragma once

#include "striate/agent/body.hpp"

namespace striate::agent {

/// The robot behind the rosbridge server that the settings name, with the camera of
/// `pioneer.devices.camera` where that is set, else with images that come as topics. Waits until it
/// is there.
/// @throws UserError, std::runtime_error, when woken, see rosbridge::RosbridgeRobot
[[nodiscard]] BodySource robot_behind_rosbridge();

}  // namespace striate::agent
