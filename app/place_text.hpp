#pragma once

#include <string>

#include "platform/interface/geometry.hpp"

namespace striate {

/// Reads "12 m, 0.2 m, 5 deg": along the corridor, left of its middle, heading (may be left out).
/// @throws UserError saying what is wrong with it.
[[nodiscard]] Pose2 parse_place(const std::string& text);

/// Reads "12.3 s" or "2 min", given with `option`. @throws UserError saying what is wrong with it.
[[nodiscard]] double parse_time_s(const std::string& option, const std::string& text);

}  // namespace striate
