#pragma once

#include <string>

#include "striate/agent/body.hpp"

namespace striate::agent {

/// The body that the robot's YAML names, of a plugin. Where it names none: the robot behind the
/// rosbridge server that it tells of, else the real Pioneer.
/// @param robot_file "": the built-in settings
/// @throws UserError with all mistakes of the file; when woken, as the body does
[[nodiscard]] BodySource named_body(const std::string& robot_file);

}  // namespace striate::agent
