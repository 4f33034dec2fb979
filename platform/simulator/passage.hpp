#pragma once

#include <string>

#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// How wide the way from start to goal is, and where it is narrowest.
struct Passage {
  double width_m = 0.0;  ///< of the widest disc that gets through; 0: nothing does
  Point2 at;             ///< in the plan: the middle of the narrowest gap of the best way
  std::string one;       ///< what stands on its one side: "wall", "table_1", "person"
  std::string other;     ///< and on the other
};

/// The widest disc that can go from the start to anywhere beyond the goal line, past everything
/// that ever stands there: walls, pillars, obstacles (late ones too) and people who stand. Exact,
/// by the flat plan: no grid. Those who walk are not asked.
[[nodiscard]] Passage widest_passage(const World& world, const FloorPlan& plan);

}  // namespace striate::simulator
