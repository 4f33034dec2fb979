#pragma once

#include <string>

#include "striate/agent/body.hpp"

namespace striate::agent {

/// The body that the robot's YAML names, of a plugin; the real Pioneer where it names none.
/// @param robot_file "": the built-in settings
/// @throws UserError with all mistakes of the file; when woken, as the body does
[[nodiscard]] BodySource named_body(const std::string& robot_file);

}  // namespace striate::agent
