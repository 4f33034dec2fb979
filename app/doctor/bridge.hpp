#pragma once

#include "striate/agent/robot_settings.hpp"
#include "striate/app/doctor/finding.hpp"

namespace striate::app {

/// The rosbridge server that a robot file names: does it answer, and do images and odometry come?
/// Nothing moves. Nothing is found where none is named.
/// @param patience how long images and odometry are waited for
[[nodiscard]] Findings look_at_bridge(const agent::RobotSettings& settings,
                                      Duration patience = std::chrono::seconds(5));

}  // namespace striate::app
