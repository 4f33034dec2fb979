#pragma once

#include <span>
#include <vector>

#include "striate/perception/visual_odometry/motion_estimate.hpp"
#include "striate/perception/visual_odometry/no_estimate.hpp"
#include "striate/perception/visual_odometry/odometry_settings.hpp"
#include "striate/perception/visual_odometry/stereo_points.hpp"

namespace striate::perception {

/// A point of an earlier view that is seen again and agrees on the motion.
struct FollowedPoint {
  std::size_t then = 0;  ///< index of the point in the earlier view
  std::size_t now = 0;   ///< in this one
  StereoSight sight;     ///< where this view shows what the earlier one did at its place
};

/// What became of an earlier view's points.
struct Followed {
  NoEstimate reason = NoEstimate::too_few_matches;
  MotionEstimate motion;
  std::vector<FollowedPoint> points;
  int matches = 0;
  double median_depth_m = 0.0;  ///< of the points, now
  double median_flow_px = 0.0;  ///< how far they went in the image

  [[nodiscard]] bool good() const { return reason == NoEstimate::none; }
};

/// Looks for the earlier view's points where each of the expected motions puts them, first near by,
/// then in a wide window; then anew, close to where the motion that was found puts them, and to a
/// small part of a pixel.
/// @param expected now from then, the likeliest first; at least one
[[nodiscard]] Followed follow_points(const StereoLook& then, const StereoLook& now,
                                     std::span<const RigidMotion> expected,
                                     const VisualOdometrySettings& settings);

}  // namespace striate::perception
