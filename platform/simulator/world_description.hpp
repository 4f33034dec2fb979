#pragma once

#include <string>

#include "striate/platform/simulator/passage.hpp"
#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// What a person wants to know of a world before driving there, in lines: its shape, its narrowest
/// passage, light, things, people.
[[nodiscard]] std::string describe_world(const World& world, const FloorPlan& plan,
                                         const Passage& passage);

}  // namespace striate::simulator
