#pragma once

#include "striate/agent/simulated_body.hpp"

/// The bodies that `striate ros` drives.
namespace striate::agent {

/// The simulated Pioneer in a world, in real time; nobody judges it or ends its run. Reads the
/// world at once. @throws UserError with all mistakes of the world
[[nodiscard]] BodySource pioneer_in_real_time(const WorldOptions& options);

/// The robot behind the topics that the settings name. Waits until it is there.
/// @throws UserError, std::runtime_error, when woken, see ros1::RosRobot
[[nodiscard]] BodySource robot_behind_ros();

}  // namespace striate::agent
