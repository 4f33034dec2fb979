#pragma once

#include <Eigen/Core>
#include <vector>

#include "striate/perception/visual_odometry/rigid_motion.hpp"
#include "striate/perception/visual_odometry/stereo_eyes.hpp"

namespace striate::perception {

/// One sight of a point from one camera.
struct BundleSight {
  int camera = 0;
  int point = 0;
  StereoSight sight;
  double noise_px = 1.0;
};

/// Cameras and points that are to fit what was seen. Camera 0 stays.
struct Bundle {
  StereoEyes eyes;
  double noise_px = 1.0;
  std::vector<RigidMotion> camera_from_world;
  std::vector<cv::Vec3d> points_m;
  std::vector<BundleSight> sights;  ///< by point
};

/// What the sights cost (Cauchy's loss), in chi squared; points behind a camera cost much.
[[nodiscard]] double bundle_cost(const Bundle& bundle);

/// One damped step (Levenberg 1944, Marquardt 1963): the points are eliminated first (Schur), since
/// none depends on another. @return false: the equations have no solution
[[nodiscard]] bool bundle_step(const Bundle& bundle, double damping, Bundle& moved);

}  // namespace striate::perception
