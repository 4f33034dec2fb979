#include "striate/perception/obstacles/wall_completion.hpp"

#include <algorithm>
#include <cmath>

#include "striate/perception/obstacles/floor_state.hpp"

namespace striate::perception {
namespace {

/// Of the corridor; above what makes it valid (0.3), for this puts in what nobody saw
constexpr double kLeastConfidence = 0.4;
/// Confidence of the wall against that of the corridor: inferred, so never above 0.5
constexpr double kCounts = 0.5;
/// As far as walls are measured, less a cell (wall_profile.cpp, 6.5 m)
constexpr double kFarthestWall_m = 6.0;
/// Times the wall's distance; one px of disparity at 5 m is a fifth of it
constexpr double kBehind = 1.2;
/// Share of a column's pixels that opens the wall; an open door shows more (ours)
constexpr double kSeenThrough = 0.3;
constexpr double kTrustedWall = 0.3;  // confidence, as ObstacleSettings::trusted
/// Free floor ends before the wall, as before an obstacle (obstacles.cpp)
constexpr double kWallClearance_m = 0.05;

/// Sine, 3 deg: a ray so nearly along the corridor meets no wall within kFarthestWall_m
constexpr double kAlong = 0.05;
/// Above the floor: what one px of disparity is worth in height 2 m away (1.2 m / 12 px)
constexpr double kLowestWall_m = 0.1;
/// Below the ceiling of the shipped corridors (2.7 m), by an error of one px 6 m away
constexpr double kHighestWall_m = 2.4;

/// Distance along `bearing_rad` to the wall on that side; +inf for none.
double wall_range_m(const CorridorView& corridor, double bearing_rad) {
  const double turn = wrap_angle(bearing_rad - corridor.heading_rad);
  const double sine = std::sin(turn);
  if (std::abs(sine) < kAlong) return kNothing_m;
  const double side_m = sine > 0.0 ? corridor.left_m : corridor.right_m;
  return side_m / std::abs(sine);
}

/// Share of the column's pixels that are trusted to be farther than `range_m` and above the floor.
double share_behind(const DisparityMap& map, const ViewGeometry& geometry, int u, double range_m) {
  int behind = 0;
  for (int v = 0; v < map.disparity_px.rows; ++v) {
    const float d = map.disparity_px(v, u);
    if (!std::isfinite(d) || d <= 0.0F || map.confidence(v, u) < kTrustedWall) continue;
    const double height = geometry.height_m(v, d);
    if (height < kLowestWall_m || height > kHighestWall_m) continue;
    const SpacePoint p = geometry.point(u, v, d);
    behind += std::hypot(p.x_m, p.y_m) > kBehind * range_m;
  }
  return static_cast<double>(behind) / map.disparity_px.rows;
}

}  // namespace

void complete_with_walls(std::vector<Column>& columns, const CorridorView& corridor,
                         const DisparityMap& map, const ViewGeometry& geometry) {
  if (!corridor.valid || corridor.confidence < kLeastConfidence) return;
  for (int u = 0; u < static_cast<int>(columns.size()); ++u) {
    Column& column = columns[u];
    const double range_m = wall_range_m(corridor, column.bearing_rad);
    if (range_m > kFarthestWall_m || column.obstacle_m < kBehind * range_m) continue;
    if (share_behind(map, geometry, u, range_m) > kSeenThrough) continue;
    column.obstacle_m = range_m;
    column.obstacle_confidence = kCounts * corridor.confidence;
    hide_behind_obstacle(column, kNothing_m);  // walls are higher than the camera
    column.free_to_m = std::min(column.free_to_m, range_m - kWallClearance_m);
    if (column.free_to_m <= column.free_from_m) {
      column.free_from_m = column.free_to_m = column.free_confidence = 0.0;
    }
  }
}

}  // namespace striate::perception
