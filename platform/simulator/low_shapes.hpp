#pragma once

#include <vector>

#include "striate/platform/simulator/static_shapes.hpp"

namespace striate::simulator {

/// What stands on the floor at the height of sonar and laser: of tables and chairs the legs alone,
/// of a plant the pot, of a glass pane the posts. Of stairs that go down nothing.
[[nodiscard]] std::vector<StaticShape> low_shapes(const World& world, const FloorPlan& plan);

/// Glass panes: sound comes back from them, a laser's light goes through.
[[nodiscard]] std::vector<StaticShape> glass_shapes(const World& world, const FloorPlan& plan);

}  // namespace striate::simulator
