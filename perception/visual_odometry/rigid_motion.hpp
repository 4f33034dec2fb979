#pragma once

#include <cmath>
#include <opencv2/core/matx.hpp>

namespace striate::perception {

/// A rigid motion in space: x' = rotation x + way. As a pose: from the thing's axes to the world's.
struct RigidMotion {
  cv::Matx33d rotation = cv::Matx33d::eye();
  cv::Vec3d way_m{};
};

/// First b, then a.
[[nodiscard]] inline RigidMotion operator*(const RigidMotion& a, const RigidMotion& b) {
  return {a.rotation * b.rotation, a.rotation * b.way_m + a.way_m};
}

[[nodiscard]] inline cv::Vec3d operator*(const RigidMotion& a, const cv::Vec3d& point_m) {
  return a.rotation * point_m + a.way_m;
}

[[nodiscard]] inline RigidMotion inverse(const RigidMotion& a) {
  return {a.rotation.t(), -(a.rotation.t() * a.way_m)};
}

/// About the axis along the vector, by its length in rad (Rodrigues).
[[nodiscard]] cv::Matx33d rotation_about(const cv::Vec3d& turn_rad);
/// Its inverse: length 0..pi.
[[nodiscard]] cv::Vec3d turn_of(const cv::Matx33d& rotation);

/// The motion and a small one after it. @param step way in m, then turn in rad
[[nodiscard]] RigidMotion nudged(const RigidMotion& motion, const cv::Vec6d& step);

/// The step that leads from b to a: a = nudged(b, step).
[[nodiscard]] cv::Vec6d step_between(const RigidMotion& a, const RigidMotion& b);

/// Standard deviation over three axes together, of a step's covariance: 0 for the way, 3 the turn.
[[nodiscard]] inline double spread_of(const cv::Matx66d& covariance, int from) {
  return std::sqrt(covariance(from, from) + covariance(from + 1, from + 1) +
                   covariance(from + 2, from + 2));
}

/// A rotation of many factors stays one: its axes are made orthogonal again.
[[nodiscard]] RigidMotion straightened(const RigidMotion& motion);

}  // namespace striate::perception
