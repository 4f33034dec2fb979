#pragma once

#include <string>

#include "striate/config/diagnostics.hpp"
#include "striate/platform/simulator/world.hpp"

/// The world language: see config/worlds/README.md.
namespace striate::simulator {

/// Reads the world file `mistakes.file()` and checks it: syntax, units, ranges, and what makes
/// sense in a corridor (inside the walls, nothing on the start, from before to). Every mistake is
/// added with its place; the world is worth something only if `mistakes.none()`.
[[nodiscard]] World read_world(config::Diagnostics& diagnostics);

/// The same for a text at hand; `mistakes.file()` names it and gives the folder of its images.
[[nodiscard]] World parse_world(const std::string& text, config::Diagnostics& diagnostics);

/// Reads a world file; throws UserError with all its mistakes (`file:line:column: error: ...`).
[[nodiscard]] World load_world(const std::string& file);

}  // namespace striate::simulator
