#pragma once

#include <functional>
#include <string>

#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// What a person should know about the entries of a written world; either may be empty.
struct WorldNotes {
  std::string head;  ///< comment lines at the top, without their '#'
  /// What to say before the obstacle of this place in `World::obstacles`; "": nothing.
  std::function<std::string(std::size_t)> obstacle;
};

/// The world as a file of the world language. What parse_world() reads from it is the same world,
/// lengths to the millimetre and angles to the hundredth of a degree.
[[nodiscard]] std::string world_as_yaml(const World& world, const WorldNotes& notes = {});

}  // namespace striate::simulator
