#pragma once

#include "striate/perception/visual_odometry/rigid_motion.hpp"
#include "striate/perception/visual_odometry/stereo_eyes.hpp"

namespace striate::perception {

/// A point that was seen then and is seen now.
struct MotionSight {
  cv::Vec3d point_m;          ///< in the camera's frame then
  double disparity_px = 0.0;  ///< then, which its depth is from
  double then_noise = 1.0;    ///< of that disparity, in `noise_px`; less where it is of many images
  StereoSight now;
  double noise_px = 1.0;  ///< of all numbers now; only ratios between sights count
};

/// What a motion leaves of a sight.
struct SightError {
  cv::Vec3d residual_px;
  cv::Matx33d weight;     ///< inverse of the residual's covariance, for a noise of 1 px
  cv::Vec3d point_now_m;  ///< where the motion puts the point
  double squared = 0.0;   ///< residual weighed: of chi squared with 3 degrees of freedom, in px^2
};

/// The depth then is no truth: its error along the line of sight then is seen now, too, and weighs
/// like noise. That makes this, to first order, the estimate that moves the points as well.
/// @return false: the point would be behind the camera
[[nodiscard]] bool judge_sight(const MotionSight& sight, const StereoEyes& eyes,
                               const RigidMotion& now_from_then, SightError& error);

/// Normal equations of one step, as nudged() takes it.
struct StepEquations {
  cv::Matx66d information = cv::Matx66d::zeros();
  cv::Vec6d pull{};

  void add(const SightError& error, const StereoEyes& eyes, double weight);
  /// @return false: the sights do not fix a motion
  [[nodiscard]] bool solve(cv::Vec6d& step) const;
};

/// The inverse of a symmetrical matrix. @return false: it is not positive
[[nodiscard]] bool invert(const cv::Matx66d& information, cv::Matx66d& covariance);

}  // namespace striate::perception
