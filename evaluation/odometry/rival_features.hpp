#pragma once

#include <string>
#include <vector>

#include "striate/perception/visual_odometry/features.hpp"

namespace striate::evaluation {

/// What visual odometry is run with.
struct OdometryMethod {
  std::string name;
  perception::FeatureSource source;
};

/// Striate's keypoints and descriptors, and OpenCV's ORB and SIFT in their place; all else is the
/// same. Of all three, thresholds are low enough for as many keypoints as are asked for, which are
/// then spread alike.
[[nodiscard]] std::vector<OdometryMethod> odometry_methods();

}  // namespace striate::evaluation
