#pragma once

#include <string>

#include "striate/base/geometry.hpp"

namespace striate::app {

/// Reads "12 m, 0.2 m, 5 deg": along the corridor, left of its middle, heading (may be left out).
/// @throws UserError saying what is wrong with it.
[[nodiscard]] Pose2 parse_pose(const std::string& text);

/// Reads "12.3 s" or "2 min", given with `option`. @throws UserError saying what is wrong with it.
[[nodiscard]] double parse_time_s(const std::string& option, const std::string& text);

}  // namespace striate::app
