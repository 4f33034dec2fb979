#pragma once

#include <optional>
#include <vector>

#include "striate/platform/simulator/static_shapes.hpp"

namespace striate::simulator {

/// How far every place of the plan is from the nearest wall, pillar, or obstacle, on a grid: quick
/// to ask, which people do all the time, and a map to find ways on.
class ClearanceMap {
 public:
  ClearanceMap(const World& world, const FloorPlan& plan);

  /// Distance from a point to the nearest thing that stands; 0 inside things and outside the walls.
  [[nodiscard]] double at(Point2 place) const;

  /// Whether a disc of this radius can go straight from a to b.
  [[nodiscard]] bool straight_is_free(Point2 from, Point2 to, double radius_m) const;

  /// A short way for a disc of this radius, corners only, both ends included; nothing where there
  /// is none.
  [[nodiscard]] std::optional<std::vector<Point2>> way(Point2 from, Point2 to,
                                                       double radius_m) const;

 private:
  [[nodiscard]] Point2 place_of(int cell) const;
  [[nodiscard]] int cell_at(Point2 place) const;
  void fill(const World& world, const FloorPlan& plan);
  [[nodiscard]] std::vector<int> cells_on_path(int from, int to, double radius_m) const;

  Point2 origin_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> clearance_m_;
};

}  // namespace striate::simulator
