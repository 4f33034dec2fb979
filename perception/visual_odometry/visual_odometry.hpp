#pragma once

#include <cstddef>
#include <memory>

#include "striate/perception/visual_odometry/features.hpp"
#include "striate/perception/visual_odometry/no_estimate.hpp"
#include "striate/perception/visual_odometry/odometry_settings.hpp"
#include "striate/perception/visual_odometry/rigid_motion.hpp"
#include "striate/perception/visual_odometry/stereo_eyes.hpp"

namespace striate::perception {

/// Where the camera is. The world is the left camera where it began: x right, y down, z forward.
struct VisualPose {
  NoEstimate reason = NoEstimate::beginning;
  RigidMotion world_from_camera;  ///< where there is no estimate: the last one
  /// The way since the estimate before is not known: from here on it goes on from there.
  bool begun_anew = false;
  bool keyframe = false;  ///< later views are compared with this one

  /// What was measured: the motion from the keyframe, and its covariance: of the step from the true
  /// motion to this one (nudged()), way in m and turn in rad, in the axes of the camera now.
  RigidMotion camera_from_keyframe;
  /// Which view that keyframe is, counted from 0 by see(). Mostly the last that said `keyframe`;
  /// where that is out of sight, the last view with an estimate takes its place afterwards.
  std::size_t keyframe_number = 0;
  cv::Matx66d covariance = cv::Matx66d::zeros();

  int points = 0;         ///< seen by both
  int matches = 0;        ///< of them, seen again
  int agreeing = 0;       ///< of them, that agree on the motion
  double noise_px = 0.0;  ///< measured, of a fine keypoint's place

  [[nodiscard]] bool known() const { return reason == NoEstimate::none; }
  /// Is world_from_camera where this view was? It is so where the world begins, too.
  [[nodiscard]] bool placed() const {
    return known() || (reason == NoEstimate::beginning && !begun_anew);
  }
  /// Standard deviation of the motion from the keyframe, over the axes together.
  [[nodiscard]] double sigma_m() const { return spread_of(covariance, 0); }
  [[nodiscard]] double sigma_rad() const { return spread_of(covariance, 3); }
};

/// Stereo visual odometry: the motion of a pair of eyes from what they see, one view after the
/// other. Estimates are made against the last keyframe, so that a camera that stands does not
/// drift. The same views give the same poses, bit for bit; there is no clock and no random number.
class VisualOdometry {
 public:
  /// With V1 keypoints and Striate's descriptor, or with features of any other kind.
  explicit VisualOdometry(const VisualOdometrySettings& settings);
  VisualOdometry(const VisualOdometrySettings& settings, FeatureSource source);
  ~VisualOdometry();
  VisualOdometry(VisualOdometry&&) noexcept;
  VisualOdometry& operator=(VisualOdometry&&) noexcept;

  /// The next view. One of another camera or size than the last begins anew.
  /// @throws std::invalid_argument for what check_view() refuses; nothing is changed then
  const VisualPose& see(const StereoView& view);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::perception
