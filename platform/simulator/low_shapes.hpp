#pragma once

#include <vector>

#include "striate/platform/simulator/static_shapes.hpp"

namespace striate::simulator {

/// What stands on the floor at the height of sonar and laser: of tables and chairs the legs alone,
/// of a plant the pot.
[[nodiscard]] std::vector<StaticShape> low_shapes(const World& world, const FloorPlan& plan);

}  // namespace striate::simulator
