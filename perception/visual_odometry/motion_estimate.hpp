#pragma once

#include <span>
#include <vector>

#include "striate/perception/visual_odometry/motion_sights.hpp"

namespace striate::perception {

struct MotionEstimateSettings {
  double agree_px = 2.5;   ///< a sight agrees with a guess within it; three of a keypoint's errors
  double sure = 0.999;     ///< that one guess of three sights was made of right ones
  int most_guesses = 300;  ///< then 20 % of right sights are found with nine in ten (by hand)
  double least_noise_px =
      0.03;  ///< no image is better; keeps made-up data from weights of infinity
};

struct MotionEstimate {
  bool found = false;
  RigidMotion now_from_then;
  /// Of the step that leads from the true motion to the estimated one: way in m, then turn in rad,
  /// in the camera's axes now.
  cv::Matx66d covariance = cv::Matx66d::zeros();
  double noise_px = 0.0;     ///< measured, of sights whose noise_px is 1
  std::vector<char> agrees;  ///< one a sight
  int agreeing = 0;
};

/// The guess of three sights with which most agree (RANSAC, Fischler and Bolles 1981; the same
/// sights, the same guesses). Guesses start at `from`, which is tried as it is, too.
[[nodiscard]] MotionEstimate find_motion(std::span<const MotionSight> sights,
                                         const StereoEyes& eyes, const RigidMotion& from,
                                         const MotionEstimateSettings& settings);

/// Least squares from a motion that is nearly right, over the sights that agree with it, with
/// weights that fall with the residual (Cauchy's), by the noise that is measured; and its
/// covariance.
[[nodiscard]] MotionEstimate refine_motion(std::span<const MotionSight> sights,
                                           const StereoEyes& eyes, const RigidMotion& from,
                                           const MotionEstimateSettings& settings);

}  // namespace striate::perception
