#include "striate/perception/hanging_edges/hanging_edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

/// Nearest that edges are sought, m: nearer, a robot of 0.21 m before its axle has met them
constexpr double kNearestEdge_m = 0.5;
constexpr int kShortestEdge_px = 12;  // columns; shorter ones have too little of a direction (ours)
/// Rows between the two eyes, px: rectification errs by 0.15 px, a row's place by as much
constexpr double kSameRow_px = 1.0;
/// An end errs by a column in each eye, px ...
constexpr double kEndErrs_px = 1.5;
/// ... and by this share where the edge fades (by hand)
constexpr double kEndErrs = 0.05;
/// Nearer to the horizon a row says nothing about the distance, px: what the servo's step is worth
constexpr double kAtHorizon_px = 5.0;

/// How much nearer a level edge is in row `v` than in row `at`.
double nearer_by(const ViewGeometry& geometry, double v, double at) {
  const double below = at - geometry.horizon_v_px();
  if (std::abs(below) < kAtHorizon_px) return 1.0;
  return std::max(0.0, (v - geometry.horizon_v_px()) / below);
}

/// Where the same edge of both eyes hangs; nothing where they do not go together.
std::optional<HangingEdge> pair_up(const LevelEdge& left, const LevelEdge& right,
                                   const ViewGeometry& geometry) {
  if (left.brightens != right.brightens) return std::nullopt;
  const bool left_end = !left.cut_left && !right.cut_left;
  const bool right_end = !left.cut_right && !right.cut_right;
  if (!left_end && !right_end) return std::nullopt;
  const double from_px = left.from_u_px - right.from_u_px;
  const double to_px = left.to_u_px - right.to_u_px;
  if (left_end && std::abs(left.row_px.front() - right.row_px.front()) > kSameRow_px) {
    return std::nullopt;
  }
  if (right_end && std::abs(left.row_px.back() - right.row_px.back()) > kSameRow_px) {
    return std::nullopt;
  }
  HangingEdge found;
  found.edge = left;
  found.both_ends = left_end && right_end;
  found.disparity_px = left_end ? from_px : to_px;
  found.at_u_px = left_end ? left.from_u_px : left.to_u_px;
  if (found.disparity_px <= 0.0) return std::nullopt;
  if (!found.both_ends) return found;
  const double expected_px = from_px * nearer_by(geometry, left.row_px.back(), left.row_px.front());
  if (std::abs(to_px - expected_px) > kEndErrs_px + kEndErrs * from_px) return std::nullopt;
  return found;
}

bool matters(const HangingEdge& found, const HangingEdgeSettings& settings) {
  return found.height_m >= settings.lowest_m && found.height_m <= settings.highest_m &&
         found.distance_m <= settings.farthest_m;
}

}  // namespace

std::vector<HangingEdge> find_hanging_edges(const cv::Mat1b& left, const cv::Mat1b& right,
                                            const ViewGeometry& geometry,
                                            const HangingEdgeSettings& settings) {
  std::vector<HangingEdge> hanging;
  const double above_px =
      geometry.focal_px() * (settings.highest_m - geometry.camera_height_m()) / kNearestEdge_m;
  const int from_row = floor_within(geometry.horizon_v_px() - above_px, 0, left.rows);
  const cv::Range rows(from_row, left.rows);
  const std::vector<LevelEdge> in_left = find_level_edges(left, rows, kShortestEdge_px);
  if (in_left.empty()) return hanging;
  const std::vector<LevelEdge> in_right = find_level_edges(right, rows, kShortestEdge_px);
  const double baseline_m = geometry.focal_baseline() / geometry.focal_px();
  for (const LevelEdge& edge : in_left) {
    std::optional<HangingEdge> best;
    for (const LevelEdge& other : in_right) {
      std::optional<HangingEdge> found = pair_up(edge, other, geometry);
      if (!found) continue;
      // Of several the one that both ends agree on, then the farthest: less is claimed.
      const bool better =
          !best || (found->both_ends && !best->both_ends) ||
          (found->both_ends == best->both_ends && found->disparity_px < best->disparity_px);
      if (better) best = std::move(found);
    }
    if (!best) continue;
    const double row = best->edge.row_at(best->at_u_px);
    const SpacePoint end = geometry.point(best->at_u_px, row, best->disparity_px);
    best->height_m = end.z_m;
    best->distance_m = std::hypot(end.x_m, end.y_m);
    const double length_m = edge.length_px() * baseline_m / best->disparity_px;
    if (matters(*best, settings) && length_m >= settings.shortest_m) {
      hanging.push_back(std::move(*best));
    }
  }
  return hanging;
}

}  // namespace striate::perception
