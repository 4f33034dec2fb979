#pragma once

#include <vector>

#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::perception {

/// The trusted points above the floor, up to the ceiling: what may be wall.
[[nodiscard]] std::vector<SpacePoint> collect_wall_points(const DisparityMap& map,
                                                          const ViewGeometry& geometry);

/// A wall that runs along the corridor, on one side.
struct Wall {
  double distance_m = kNothing_m;  ///< from the axle, square to the corridor; kNothing_m: not seen
  double structure = 0.0;          ///< cells of 0.25 m along x 0.3 m up that show it
  double along_m = 0.0;            ///< length of the corridor over which it shows
};

struct Walls {
  Wall left;
  Wall right;
  [[nodiscard]] double structure() const { return left.structure + right.structure; }
};

/// Walls parallel to the direction `heading_rad` (robot frame): the strongest concentration of
/// points at one sideways distance. What counts is how much of the wall's length and height is
/// covered, not how many points there are, so that one near, well textured box is no wall.
[[nodiscard]] Walls find_walls(const std::vector<SpacePoint>& points, double heading_rad);

}  // namespace striate::perception
