#include "striate/perception/visual_odometry/follow_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "striate/base/median.hpp"

namespace striate::perception {
namespace {

constexpr std::size_t kNoPoint = std::numeric_limits<std::size_t>::max();
constexpr double kGuided =
    0.008;  // of the width, round where a known motion puts a point (by hand)
constexpr double kLeastGuided_px = 4.0;  // px: twice what coarse keypoints err (by hand)

/// One view's points and another's.
class Follower {
 public:
  Follower(const StereoLook& then, const StereoLook& now, const VisualOdometrySettings& settings)
      : then_(then), now_(now), settings_(settings), grid_(now.left, now.size) {
    point_of_feature_.assign(now.left.size(), kNoPoint);
    for (std::size_t k = 0; k < now.points.size(); ++k) {
      point_of_feature_[now.points[k].left] = k;
    }
    for (const StereoPoint& point : then.points) {
      places_m_.push_back(point_of(then.eyes, point.sight));
    }
  }

  /// Points that are found again in the other view, and in both eyes of it.
  [[nodiscard]] std::vector<FollowedPoint> match(const RigidMotion& motion,
                                                 double radius_px) const {
    std::vector<LookedFor> looked_for;
    std::vector<std::size_t> points;
    for (std::size_t k = 0; k < places_m_.size(); ++k) {
      const cv::Vec3d p = motion * places_m_[k];
      constexpr double kNearestSharp_m = 0.02;  // nearer nothing is in focus (by hand)
      if (p[2] < kNearestSharp_m) continue;
      const StereoSight sight = sight_of(now_.eyes, p);
      if (!(std::abs(sight[0]) < 2.0 * now_.size.width &&
            std::abs(sight[1]) < 2.0 * now_.size.height)) {
        continue;
      }
      looked_for.push_back({then_.points[k].left, sight[0], sight[1]});
      points.push_back(k);
    }
    std::vector<FollowedPoint> found;
    for (const FeaturePair& pair :
         match_near(then_.left, looked_for, now_.left, grid_, radius_px, {})) {
      const std::size_t now = point_of_feature_[pair.to];
      if (now == kNoPoint) continue;
      const std::size_t then = points[pair.from];
      // The circle closes where the right eye sees the same, too.
      if (descriptor_distance(then_.right, then_.points[then].right, now_.right,
                              now_.points[now].right) > now_.right.most_distance) {
        continue;
      }
      found.push_back({then, now, now_.points[now].sight});
    }
    return found;
  }

  /// Where this view shows what the earlier one did, and not only a keypoint like it.
  [[nodiscard]] std::vector<FollowedPoint> refine(const std::vector<FollowedPoint>& matched,
                                                  const RigidMotion& motion) const {
    const cv::Matx33d& r = motion.rotation;
    const double roll_rad = std::atan2(r(1, 0) - r(0, 1), r(0, 0) + r(1, 1));
    const double c = std::cos(roll_rad), s = std::sin(roll_rad);
    std::vector<FollowedPoint> refined;
    for (FollowedPoint point : matched) {
      const StereoPoint& before = then_.points[point.then];
      const double shrink = (motion * places_m_[point.then])[2] / places_m_[point.then][2];
      const cv::Matx22d back(shrink * c, shrink * s, -shrink * s, shrink * c);
      const PatchPlace place =
          find_patch(then_.left_picture, {before.sight[0], before.sight[1]}, now_.left_picture,
                     {point.sight[0], point.sight[1]}, back, before.level, PatchSettings{});
      if (place.result != PatchPlace::Result::found) continue;
      point.sight[0] = place.u_px;
      point.sight[1] = place.v_px;
      refined.push_back(point);
    }
    return refined;
  }

  /// @param refined by patches: then the level says how exact a place is; else the keypoint's scale
  [[nodiscard]] std::vector<MotionSight> sights(const std::vector<FollowedPoint>& points,
                                                bool refined) const {
    std::vector<MotionSight> sights;
    for (const FollowedPoint& point : points) {
      const StereoPoint& before = then_.points[point.then];
      const double noise_px =
          refined ? std::ldexp(1.0, before.level) : then_.left.features[before.left].scale;
      sights.push_back({places_m_[point.then], before.sight[2],
                        before.then_noise * (refined ? noise_px : 1.0), point.sight, noise_px});
    }
    return sights;
  }

  [[nodiscard]] bool enough(int agreeing, std::size_t matches) const {
    return agreeing >= settings_.least_points &&
           agreeing >= settings_.least_share * static_cast<double>(matches);
  }

 private:
  const StereoLook& then_;
  const StereoLook& now_;
  const VisualOdometrySettings& settings_;
  FeatureGrid grid_;
  std::vector<std::size_t> point_of_feature_;
  std::vector<cv::Vec3d> places_m_;
};

/// The points that agree, and what is said of them.
void keep_agreeing(const StereoLook& then, const std::vector<FollowedPoint>& points,
                   Followed& followed) {
  std::vector<double> depths_m, flows_px;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (followed.motion.agrees[k] == 0) continue;
    followed.points.push_back(points[k]);
    const StereoSight& before = then.points[points[k].then].sight;
    const StereoSight& after = points[k].sight;
    depths_m.push_back(then.eyes.focal_px * then.eyes.baseline_m / after[2]);
    flows_px.push_back(std::hypot(after[0] - before[0], after[1] - before[1]));
  }
  followed.median_depth_m = median_of(std::move(depths_m));
  followed.median_flow_px = median_of(std::move(flows_px));
}

/// A motion that enough points agree on, with keypoints as exact as they are.
MotionEstimate first_motion(const Follower& follower, const StereoLook& now,
                            std::span<const RigidMotion> expected,
                            const VisualOdometrySettings& settings, Followed& followed) {
  MotionEstimate best;
  for (const double window : {settings.window, settings.wide_window}) {
    for (const RigidMotion& motion : expected) {
      const auto matched = follower.match(motion, window * now.size.width);
      followed.matches = std::max(followed.matches, static_cast<int>(matched.size()));
      if (static_cast<int>(matched.size()) < settings.least_points) continue;
      const auto sights = follower.sights(matched, false);
      MotionEstimate found = find_motion(sights, now.eyes, motion, {});
      if (!found.found || found.agreeing <= best.agreeing) continue;
      best = std::move(found);
      if (!follower.enough(best.agreeing, matched.size())) continue;
      followed.reason = NoEstimate::none;
      return best;
    }
  }
  followed.reason = followed.matches < settings.least_points ? NoEstimate::too_few_matches
                                                             : NoEstimate::no_agreement;
  return best;
}

}  // namespace

Followed follow_points(const StereoLook& then, const StereoLook& now,
                       std::span<const RigidMotion> expected,
                       const VisualOdometrySettings& settings) {
  Followed followed;
  const Follower follower(then, now, settings);
  const MotionEstimate first = first_motion(follower, now, expected, settings, followed);
  if (!followed.good()) return followed;
  const double near_px = std::max(kLeastGuided_px, kGuided * now.size.width);
  RigidMotion motion = first.now_from_then;
  const auto matched = follower.match(motion, near_px);
  const MotionEstimate rough = refine_motion(follower.sights(matched, false), now.eyes, motion, {});
  if (rough.found) motion = rough.now_from_then;
  const auto refined = follower.refine(matched, motion);
  followed.matches = static_cast<int>(refined.size());
  followed.motion = refine_motion(follower.sights(refined, true), now.eyes, motion, {});
  if (!followed.motion.found || !follower.enough(followed.motion.agreeing, refined.size())) {
    followed.reason = static_cast<int>(refined.size()) < settings.least_points
                          ? NoEstimate::too_few_matches
                          : NoEstimate::no_agreement;
    return followed;
  }
  keep_agreeing(then, refined, followed);
  return followed;
}

}  // namespace striate::perception
