#include "striate/perception/obstacles/obstacles.hpp"

#include <algorithm>
#include <cmath>

#include "striate/perception/obstacles/column_scan.hpp"
#include "striate/perception/obstacles/floor_state.hpp"
#include "striate/perception/obstacles/free_floor.hpp"
#include "striate/perception/obstacles/obstacle_blobs.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::perception {
namespace {

/// Share: a bridged column is inferred, not seen, so it is sure of nothing (below 0.5)
constexpr double kBridgedCounts = 0.5;
/// Where an empty column's bearing is taken: the middle of the 8 m of floor judged
constexpr double kBearingDistance_m = 4.0;
/// Free floor ends before the obstacle: one px of disparity at 1.1 m (Z^2 / f B)
constexpr double kClearance_m = 0.05;

/// What hangs: nothing is seen of it below this height, which is more than a pixel's at 5 m, ...
constexpr double kHangs_m = 0.35;
/// ... and the floor beneath is seen on to so far behind its front: more than a range errs at 2 m
constexpr double kSeenBeneath_m = 0.20;

/// Level disparity, px: right matches of one surface err by less ("right within 1 px")
constexpr double kSameSurface_px = 1.0;
/// Trust in a column none of whose own pixels show the surface: neither for nor against
constexpr double kUndecided = 0.5;

double mean_trust(const JudgedMap& judged, const Standing& standing, int u) {
  double sum = 0.0;
  int count = 0;
  for (int v = standing.top_row; v < judged.kind.rows; ++v) {
    if (static_cast<PixelKind>(judged.kind(v, u)) != PixelKind::standing) continue;
    if (std::abs(judged.level(v, u) - standing.level_px) > kSameSurface_px) continue;
    sum += judged.weight(v, u);
    ++count;
  }
  return count > 0 ? sum / count : kUndecided;
}

/// Just enough support gives 0.5, three times as much nearly all that the disparities deserve.
double believe(const JudgedMap& judged, const Standing& standing, int u) {
  const double seen = 1.0 - std::exp2(-standing.support);
  return seen * mean_trust(judged, standing, u) * (standing.bridged ? kBridgedCounts : 1.0);
}

ColumnHit hit_of(const Standing& standing, const JudgedMap& judged, const ViewGeometry& geometry,
                 int u) {
  ColumnHit hit;
  hit.found = standing.level_px > 0.0;
  if (!hit.found) return hit;
  const double d = standing.level_px / geometry.level_factor(standing.row_px);
  const SpacePoint p = geometry.point(u, standing.row_px, d);
  const double top_d = standing.level_px / geometry.level_factor(standing.top_row);
  hit.level_px = standing.level_px;
  hit.at = {p.x_m, p.y_m};
  hit.height_m = std::max(0.0, geometry.height_m(standing.top_row, top_d));
  const double bottom_d = standing.level_px / geometry.level_factor(standing.bottom_row);
  hit.lowest_m = std::max(0.0, geometry.height_m(standing.bottom_row, bottom_d));
  hit.confidence = believe(judged, standing, u);
  return hit;
}

/// Distance of what has the floor's disparity in row v, or `more_px` more.
double floor_range_m(const ViewGeometry& geometry, int u, double v, double more_px) {
  const SpacePoint p = geometry.point(u, v, geometry.floor_disparity_px(v) + more_px);
  return std::hypot(p.x_m, p.y_m);
}

/// The last floor seen may be the foot of something blank that rises above the floor line by less
/// than the margin: the floor is free only up to where such a thing would stand.
Column column_of(const ColumnHit& hit, const FreeFloor& free, const ViewGeometry& geometry, int u,
                 double margin_px) {
  Column column;
  if (free.from_row >= 0) {
    column.free_from_m = floor_range_m(geometry, u, free.from_row, 0.0);
    column.free_to_m = floor_range_m(geometry, u, free.to_row, margin_px);
    column.free_confidence = free.confidence;
  }
  Point2 at = geometry.level_point(u, geometry.focal_baseline() / kBearingDistance_m);
  if (hit.found) {
    at = hit.at;
    column.obstacle_m = std::hypot(at.x_m, at.y_m);
    column.obstacle_confidence = hit.confidence;
    const bool floor_beyond = column.free_to_m > column.obstacle_m + kSeenBeneath_m;
    if (floor_beyond && hit.lowest_m > kHangs_m) column.hangs_from_m = hit.lowest_m;
    column.free_to_m = std::min(column.free_to_m, column.obstacle_m - kClearance_m);
  }
  if (column.free_to_m <= column.free_from_m) {
    column.free_from_m = column.free_to_m = column.free_confidence = 0.0;
  }
  column.bearing_rad = std::atan2(at.y_m, at.x_m);
  return column;
}

/// Where the line of sight just over the obstacle's highest row meets the floor again; kNothing_m
/// for what is as high as the camera.
double sight_over_top_m(const ViewGeometry& geometry, const Standing& standing, int u) {
  const double row = standing.top_row - 1.0;
  if (geometry.floor_disparity_px(row) <= 0.0) return kNothing_m;
  return floor_range_m(geometry, u, row, 0.0);
}

}  // namespace

ObstacleView find_obstacles(const DisparityMap& map, const HeadPose& head,
                            const RobotDescription& robot, const ObstacleSettings& settings) {
  ObstacleView view;
  if (map.disparity_px.empty()) return view;
  const ViewGeometry geometry(map, head, robot);
  view.floor_offset_px = calibrate_floor(map, geometry, settings);
  const JudgedMap judged = judge_pixels(map, geometry, settings, view.floor_offset_px);
  std::vector<Standing> standing = find_standing(judged, geometry, settings);
  bridge_unknown_columns(standing, judged, settings);
  const std::vector<FreeFloor> free = find_free_floor(judged, geometry, settings);

  const int width = map.disparity_px.cols;
  std::vector<ColumnHit> hits(width);
  view.columns.resize(width);
  for (int u = 0; u < width; ++u) {
    hits[u] = hit_of(standing[u], judged, geometry, u);
    view.columns[u] = column_of(hits[u], free[u], geometry, u, settings.floor_margin_px);
    hide_behind_obstacle(view.columns[u], sight_over_top_m(geometry, standing[u], u));
  }
  view.obstacles = join_columns(hits);
  return view;
}

}  // namespace striate::perception
