#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"
#include "striate/perception/hanging_edges/hanging_edges.hpp"
#include "striate/perception/obstacles/floor_state.hpp"

namespace striate::perception {
namespace {

/// Confidence of an edge whose two ends agree: inferred, so hardly above one half ...
constexpr double kBothEnds = 0.6;
/// ... and of one that leaves the view (by hand)
constexpr double kOneEnd = 0.4;
/// Nearer by less is the same thing, seen twice, m
constexpr double kSameEdge_m = 0.10;
/// What is this sure was matched itself; filled gaps are at most 0.79 (kGapTrust)
constexpr float kMatchedItself = 0.85F;
/// Working pixels above and below the edge where stereo would see through it
constexpr int kBeside_px = 2;
/// Disparity of the working size: farther by more is behind it, px
constexpr double kBehindEdge_px = 1.5;
/// Share of an edge that stereo may see through on both sides: where a leg stands before it (ours)
constexpr double kThrough = 0.35;
/// Depth that hangs below a level edge and is not seen itself, m: a board, an apron (by hand)
constexpr double kBoard_m = 0.12;

/// A point of the edge, in pixels of the working size.
struct EdgePlace {
  int u_px = 0;
  double v_px = 0.0;
  double d_px = 0.0;
};

std::vector<EdgePlace> places_of(const HangingEdge& hanging, const ViewGeometry& geometry,
                                 int scale, int width) {
  std::vector<EdgePlace> places;
  const double horizon_px = geometry.horizon_v_px();
  const auto row = [&](int u) { return (hanging.edge.row_at(u) + 0.5) / scale - 0.5; };
  const double end_below = row(hanging.at_u_px) - horizon_px;
  constexpr double kFlat_px = 2.5;  // working px: half of kAtHorizon_px of hanging_edges.cpp
  for (int u = hanging.edge.from_u_px; u <= hanging.edge.to_u_px; u += scale) {
    const double v = row(u);
    const double nearer = std::abs(end_below) < kFlat_px ? 1.0 : (v - horizon_px) / end_below;
    if (nearer <= 0.0 || u / scale >= width) continue;
    places.push_back({u / scale, v, nearer * hanging.disparity_px / scale});
  }
  return places;
}

bool is_behind(const DisparityMap& map, int u, int v, double d_px) {
  if (v < 0 || v >= map.disparity_px.rows) return false;
  return map.confidence(v, u) >= kMatchedItself && map.disparity_px(v, u) < d_px - kBehindEdge_px;
}

bool is_seen_through(const DisparityMap& map, const std::vector<EdgePlace>& places) {
  int through = 0;
  for (const EdgePlace& place : places) {
    const int v = nearest_cell(place.v_px);
    through += is_behind(map, place.u_px, v - kBeside_px, place.d_px) &&
               is_behind(map, place.u_px, v + kBeside_px, place.d_px);
  }
  return through > kThrough * static_cast<double>(places.size());
}

void hang_in(const HangingEdge& hanging, const SpacePoint& at, Column& column) {
  const double distance_m = std::hypot(at.x_m, at.y_m);
  if (distance_m >= column.obstacle_m - kSameEdge_m) return;
  column.bearing_rad = std::atan2(at.y_m, at.x_m);
  column.obstacle_m = distance_m;
  column.obstacle_confidence = hanging.both_ends ? kBothEnds : kOneEnd;
  column.hangs_from_m = std::max(0.01, hanging.height_m - kBoard_m);
  column.free_to_m = std::min(column.free_to_m, distance_m);
  if (column.free_to_m <= column.free_from_m) {
    column.free_from_m = column.free_to_m = column.free_confidence = 0.0;
  }
  hide_behind_obstacle(column, kNothing_m);
}

}  // namespace

void add_hanging_edges(const std::vector<HangingEdge>& edges, const DisparityMap& map,
                       const ViewGeometry& geometry, int scale, ObstacleView& view) {
  if (map.disparity_px.empty() || view.columns.empty()) return;
  for (const HangingEdge& hanging : edges) {
    const std::vector<EdgePlace> places =
        places_of(hanging, geometry, scale, map.disparity_px.cols);
    if (places.empty() || is_seen_through(map, places)) continue;
    Obstacle whole;
    whole.from_u_px = places.front().u_px;
    whole.to_u_px = places.back().u_px;
    whole.distance_m = kNothing_m;
    whole.height_m = hanging.height_m;
    whole.confidence = hanging.both_ends ? kBothEnds : kOneEnd;
    for (const EdgePlace& place : places) {
      const SpacePoint at = geometry.point(place.u_px, place.v_px, place.d_px);
      hang_in(hanging, at, view.columns[static_cast<std::size_t>(place.u_px)]);
      whole.distance_m = std::min(whole.distance_m, std::hypot(at.x_m, at.y_m));
    }
    const EdgePlace& a = places.front();
    const EdgePlace& b = places.back();
    const SpacePoint left = geometry.point(a.u_px, a.v_px, a.d_px);
    const SpacePoint right = geometry.point(b.u_px, b.v_px, b.d_px);
    whole.bearing_rad = std::atan2(left.y_m + right.y_m, left.x_m + right.x_m);
    whole.width_m = std::hypot(left.x_m - right.x_m, left.y_m - right.y_m);
    view.obstacles.push_back(whole);
  }
  std::stable_sort(
      view.obstacles.begin(), view.obstacles.end(),
      [](const Obstacle& a, const Obstacle& b) { return a.distance_m < b.distance_m; });
}

}  // namespace striate::perception
