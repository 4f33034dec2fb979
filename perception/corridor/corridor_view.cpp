#include "perception/corridor/corridor_view.hpp"

#include <algorithm>
#include <cmath>

#include "perception/corridor/vanishing_point.hpp"
#include "perception/corridor/wall_profile.hpp"

namespace striate {
namespace {

constexpr double kWallsCount = 1.0;      // weight of stereo's walls against the edges' score
constexpr double kHalfBelief_px = 60.0;  // this much converging line gives half the confidence
constexpr double kOneSided = 0.6;        // lines from one side only do not cross well
constexpr double kGoodSpread_px = 1.0;
constexpr double kWallHalfBelief = 25.0;  // cells of wall that make it half sure

struct Candidate {
  VanishingPoint point;
  double heading_rad = 0.0;
  Walls walls;
  double score = 0.0;
};

/// Heading from the camera's own axis and pan: rotation of the head moves the point as a camera.
double heading_of(const VanishingPoint& point, const DisparityMap& camera, const HeadPose& head) {
  const double right = (point.u_px - camera.centre_u_px) / camera.focal_px;
  const double down = (point.v_px - camera.centre_v_px) / camera.focal_px;
  const double forward = std::cos(head.tilt_rad) + down * std::sin(head.tilt_rad);
  return wrap_angle(head.pan_rad - std::atan2(right, forward));
}

/// The camera of `map`, as it is for a picture of another size.
DisparityMap camera_for(const DisparityMap& map, cv::Size from, cv::Size to) {
  const double scale = static_cast<double>(to.width) / from.width;
  DisparityMap camera;
  camera.focal_px = map.focal_px * scale;
  camera.centre_u_px = (map.centre_u_px + 0.5) * scale - 0.5;
  camera.centre_v_px = (map.centre_v_px + 0.5) * scale - 0.5;
  camera.baseline_m = map.baseline_m;
  return camera;
}

double confidence_of(const Candidate& best, double runner_up_score) {
  const double lines_px = best.point.lines_left + best.point.lines_right;
  const bool both = std::min(best.point.lines_left, best.point.lines_right) > 10.0;
  const double edges = (1.0 - std::exp2(-lines_px / kHalfBelief_px)) * (both ? 1.0 : kOneSided) /
                       (1.0 + 0.3 * std::max(0.0, best.point.spread_px - kGoodSpread_px));
  const double walls = 1.0 - std::exp2(-best.walls.structure() / kWallHalfBelief);
  const double alone = 1.0 - 0.7 * std::min(1.0, runner_up_score / best.score);
  return alone * (1.0 - (1.0 - edges) * (1.0 - 0.5 * walls));
}

std::vector<Candidate> list_candidates(const cv::Mat1b& grey, const DisparityMap& camera,
                                       const HeadPose& head, const std::vector<SpacePoint>& points,
                                       const CorridorSettings& settings) {
  VanishingSearch search;
  search.horizon_v_px = camera.centre_v_px + camera.focal_px * std::tan(head.tilt_rad);
  const double reach_px = camera.focal_px * std::tan(settings.widest_rad);
  search.from_u_px = camera.centre_u_px - reach_px;
  search.to_u_px = camera.centre_u_px + reach_px;
  std::vector<Candidate> candidates;
  double best_edges = 0.0;
  double best_walls = 1.0;
  for (const VanishingPoint& point : find_vanishing_points(find_edge_points(grey), search)) {
    Candidate c{point, heading_of(point, camera, head), {}, 0.0};
    c.walls = find_walls(points, c.heading_rad);
    best_edges = std::max(best_edges, point.score);
    best_walls = std::max(best_walls, c.walls.structure());
    candidates.push_back(c);
  }
  for (Candidate& c : candidates) {
    c.score = c.point.score / best_edges + kWallsCount * c.walls.structure() / best_walls;
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  return candidates;
}

}  // namespace

CorridorView view_corridor(const cv::Mat1b& grey, const DisparityMap& map, const HeadPose& head,
                           const RobotDescription& robot, const CorridorSettings& settings) {
  CorridorView view;
  if (grey.empty() || map.focal_px <= 0.0) return view;
  std::vector<SpacePoint> points;
  DisparityMap camera = map;
  if (!map.disparity_px.empty() && map.baseline_m > 0.0) {
    points = collect_wall_points(map, ViewGeometry(map, head, robot));
    camera = camera_for(map, map.disparity_px.size(), grey.size());
  }
  const std::vector<Candidate> candidates = list_candidates(grey, camera, head, points, settings);
  if (candidates.empty()) return view;
  const Candidate& best = candidates.front();
  view.confidence = confidence_of(best, candidates.size() > 1 ? candidates[1].score : 0.0);
  view.valid = view.confidence >= settings.least_confidence;
  if (!view.valid) return {};
  view.heading_rad = best.heading_rad;
  view.left_m = best.walls.left.distance_m;
  view.right_m = best.walls.right.distance_m;
  return view;
}

}  // namespace striate
