#pragma once

#include <chrono>

#include "striate/base/time.hpp"

/// Limits that more than one layer must agree on.
namespace striate {

/// Below this the robot stands: a lead-acid battery of 12 V nominal (six cells, as in the Pioneer)
/// is empty under load at 1.8 V a cell, and deeper discharge ruins it. Volts.
inline constexpr double kEmptyBattery_v = 10.8;

/// A full one, standing: six cells of 2.12 V. Volts.
inline constexpr double kFullBattery_v = 12.7;

/// From a command to the first effect of the brake: one cycle of 100 ms and half of another.
inline constexpr double kBrakeLatency_s = 0.15;

/// A body obeys no command that is older: five cycles of 100 ms, after which a robot at 0.75 m/s
/// has gone less than half a metre unled.
inline constexpr Duration kCommandLease = std::chrono::milliseconds(500);

/// A wish that was not renewed for two cycles of 100 ms no longer drives.
inline constexpr Duration kWishLease = std::chrono::milliseconds(200);

}  // namespace striate
