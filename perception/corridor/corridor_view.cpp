#include "striate/perception/corridor/corridor_view.hpp"

#include <algorithm>
#include <cmath>

#include "striate/perception/corridor/upright_plane.hpp"
#include "striate/perception/corridor/vanishing_point.hpp"
#include "striate/perception/corridor/wall_profile.hpp"

namespace striate::perception {
namespace {

/// Weight in the score, where the best edges count 1: walls count as much (ours)
constexpr double kWallsCount = 1.0;
/// Of the share of pixels, at most 1: planes count as much as edges (ours)
constexpr double kPlanesCount = 1.0;
/// 11 deg (ours). Searched too, so that what lies there beats a wrong guess
constexpr double kBeyond_rad = 0.2;
/// 3.4 deg: the error of one edge's direction, as in vanishing_point.cpp
constexpr double kSameHeading_rad = 0.06;
/// So much converging line gives half the confidence; fitted, see confidence_of()
constexpr double kHalfBelief_px = 50.0;
/// A fitted line errs by as much: missing the point by it is no sign of doubt
constexpr double kGoodSpread_px = 1.0;
/// Share of belief: one line crosses nothing. 0.85 x 0.5 is valid, but not sure
constexpr double kOneLine = 0.5;
/// Score ahead of the runner-up, of at most 3, that leaves no doubt; fitted, see confidence_of()
constexpr double kClearMargin = 0.7;
/// Share of belief; 0.85 x 0.3 < least_confidence: edges that point elsewhere too do not suffice
constexpr double kLeastAlone = 0.3;
/// Share of pixels that lie on a plane by chance; fitted, see confidence_of()
constexpr double kChancePlane = 0.1;
/// Share beyond chance that leaves no doubt; fitted, see confidence_of()
constexpr double kSurePlane = 0.35;
/// Confidence from edges alone; fitted, see confidence_of(). With planes at most 0.96
constexpr double kMostOfEdges = 0.85;
/// Confidence from planes alone; fitted, see confidence_of()
constexpr double kMostOfPlanes = 0.75;
/// Belief lost for each px that the lines miss the point by; fitted, see confidence_of()
constexpr double kLostPer_px = 0.5;

/// What stereo has to say.
struct Depth {
  std::vector<SpacePoint> points;
  std::vector<UprightPlane> planes;  ///< vanishing points in the image that edges are found in
};

struct CorridorGuess {
  VanishingPoint point;
  double heading_rad = 0.0;
  Walls walls;
  double planes = 0.0;  ///< share of stereo's pixels on upright planes of this heading
  double score = 0.0;
};

/// Heading from the camera's own axis and pan: rotation of the head moves the point as a camera.
double heading_of(const VanishingPoint& point, const DisparityMap& camera, const HeadPose& head) {
  const double right = (point.u_px - camera.centre_u_px) / camera.focal_px;
  const double down = (point.v_px - camera.centre_v_px) / camera.focal_px;
  const double forward = std::cos(head.tilt_rad) + down * std::sin(head.tilt_rad);
  return wrap_angle(head.pan_rad - std::atan2(right, forward));
}

/// The camera of `map`, as it is for an image of another size.
DisparityMap camera_for(const DisparityMap& map, cv::Size from, cv::Size to) {
  const double scale = static_cast<double>(to.width) / from.width;
  DisparityMap camera;
  camera.focal_px = map.focal_px * scale;
  camera.centre_u_px = (map.centre_u_px + 0.5) * scale - 0.5;
  camera.centre_v_px = (map.centre_v_px + 0.5) * scale - 0.5;
  camera.baseline_m = map.baseline_m;
  return camera;
}

/// Edges count as far as they are long, many, meet in one place and point nowhere else as well;
/// stereo's planes count by themselves, less the more the camera looks away from the corridor's
/// axis (`aslant`: 0 along it, 1 at the widest angle). Weights fitted to simulated images of
/// known heading (tests/evaluation/obstacle_table): above 0.5 the heading was within 2 degrees.
double confidence_of(const CorridorGuess& best, double runner_up_score, double aslant) {
  const double lines_px = best.point.lines_left + best.point.lines_right;
  const double alone = std::clamp((best.score - runner_up_score) / kClearMargin, kLeastAlone, 1.0);
  const double edges = (1.0 - std::exp2(-lines_px / kHalfBelief_px)) *
                       (best.point.lines > 1 ? 1.0 : kOneLine) /
                       (1.0 + kLostPer_px * std::max(0.0, best.point.spread_px - kGoodSpread_px));
  const double planes = std::clamp((best.planes - kChancePlane) / kSurePlane, 0.0, 1.0) *
                        std::max(0.0, 1.0 - aslant * aslant) * 0.5 * (1.0 + alone);
  return 1.0 - (1.0 - kMostOfEdges * edges * alone) * (1.0 - kMostOfPlanes * planes);
}

std::vector<CorridorGuess> list_candidates(const cv::Mat1b& grey, const DisparityMap& camera,
                                           const HeadPose& head, const Depth& depth,
                                           const CorridorSettings& settings) {
  VanishingSearch search;
  search.horizon_v_px = camera.centre_v_px + camera.focal_px * std::tan(head.tilt_rad);
  const double reach_px = camera.focal_px * std::tan(settings.widest_rad + kBeyond_rad);
  search.from_u_px = camera.centre_u_px - reach_px;
  search.to_u_px = camera.centre_u_px + reach_px;
  for (const UprightPlane& plane : depth.planes) search.also_u_px.push_back(plane.vanishing_u_px);
  std::vector<CorridorGuess> candidates;
  double best_edges = 1.0;
  double best_walls = 1.0;
  for (const VanishingPoint& point : find_vanishing_points(find_edge_points(grey), search)) {
    CorridorGuess c;
    c.point = point;
    c.heading_rad = heading_of(point, camera, head);
    if (std::abs(wrap_angle(c.heading_rad - head.pan_rad)) > settings.widest_rad + kBeyond_rad) {
      continue;
    }
    c.walls = find_walls(depth.points, c.heading_rad);
    for (const UprightPlane& plane : depth.planes) {
      const VanishingPoint there{plane.vanishing_u_px, search.horizon_v_px};
      const double turn_rad = heading_of(there, camera, head) - c.heading_rad;
      if (std::abs(turn_rad) < kSameHeading_rad) c.planes += plane.share;
    }
    best_edges = std::max(best_edges, point.score);
    best_walls = std::max(best_walls, c.walls.structure());
    candidates.push_back(c);
  }
  for (CorridorGuess& c : candidates) {
    c.score = c.point.score / best_edges + kWallsCount * c.walls.structure() / best_walls +
              kPlanesCount * c.planes;
  }
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const CorridorGuess& a, const CorridorGuess& b) { return a.score > b.score; });
  return candidates;
}

}  // namespace

CorridorView view_corridor(const cv::Mat1b& grey, const DisparityMap& map, const HeadPose& head,
                           const RobotDescription& robot, const CorridorSettings& settings) {
  CorridorView view;
  if (grey.empty() || map.focal_px <= 0.0) return view;
  Depth depth;
  DisparityMap camera = map;
  if (!map.disparity_px.empty() && map.baseline_m > 0.0) {
    const ViewGeometry geometry(map, head, robot);
    depth.points = collect_wall_points(map, geometry);
    depth.planes = find_upright_planes(map, geometry,
                                       map.focal_px * std::tan(settings.widest_rad + kBeyond_rad));
    camera = camera_for(map, map.disparity_px.size(), grey.size());
    const double scale = static_cast<double>(grey.cols) / map.disparity_px.cols;
    for (UprightPlane& plane : depth.planes) {
      plane.vanishing_u_px = (plane.vanishing_u_px + 0.5) * scale - 0.5;
    }
  }
  const std::vector<CorridorGuess> candidates =
      list_candidates(grey, camera, head, depth, settings);
  if (candidates.empty()) return view;
  const CorridorGuess& best = candidates.front();
  const double aslant = wrap_angle(best.heading_rad - head.pan_rad) / settings.widest_rad;
  view.confidence = confidence_of(best, candidates.size() > 1 ? candidates[1].score : 0.0, aslant);
  view.valid = view.confidence >= settings.least_confidence && std::abs(aslant) <= 1.0;
  if (!view.valid) return {};
  view.heading_rad = best.heading_rad;
  view.left_m = best.walls.left.distance_m;
  view.right_m = best.walls.right.distance_m;
  return view;
}

}  // namespace striate::perception
