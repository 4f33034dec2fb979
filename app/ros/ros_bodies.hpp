#pragma once

#include <cstdint>
#include <string>

#include "app/robot_mission.hpp"

/// The bodies that `striate ros` drives.
namespace striate {

/// The simulated Pioneer in a world, in real time; no judge ends its run.
[[nodiscard]] RealBody simulated_body(const RobotSettings& settings, const std::string& world,
                                      std::uint64_t seed);

/// The robot behind the topics that the settings name. Waits until it is there.
/// @throws UserError, std::runtime_error, see ros1::RosRobot
[[nodiscard]] RealBody ros_body(const RobotSettings& settings);

}  // namespace striate
