#pragma once

#include <optional>
#include <vector>

#include "striate/platform/simulator/clearance_map.hpp"
#include "striate/platform/simulator/scene.hpp"

namespace striate::simulator {

/// A door as people use it, in the plan: they stand at `inside`, go through `sill`, and are gone
/// at `outside`.
struct Doorway {
  Point2 inside;
  Point2 sill;
  Point2 outside;
};

/// The doors before which there is room for a person.
[[nodiscard]] std::vector<Doorway> doorways(const World& world, const FloorPlan& plan,
                                            const ClearanceMap& map);

/// A way out from a place: to the nearest door that can be reached within `within_m`, and through.
struct WayOut {
  std::vector<Point2> way;
  Point2 door;
};
[[nodiscard]] std::optional<WayOut> way_out(Point2 from, const std::vector<Doorway>& doors,
                                            const ClearanceMap& map, double within_m);

}  // namespace striate::simulator
