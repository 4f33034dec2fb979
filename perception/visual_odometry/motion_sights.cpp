#include "striate/perception/visual_odometry/motion_sights.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace striate::perception {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Numbers of metres and of radians side by side: each row and column is brought to 1 first, so
/// that what is called singular does not depend on units.
bool decompose(const cv::Matx66d& information, Eigen::LDLT<Matrix6>& ldlt, Vector6& scale) {
  constexpr double kSingular =
      1e-12;  // of the largest pivot: what double precision leaves (by hand)
  const Eigen::Map<const Matrix6> m(information.val);
  for (int k = 0; k < 6; ++k) {
    if (!(m(k, k) > 0.0) || !std::isfinite(m(k, k))) return false;
    scale[k] = 1.0 / std::sqrt(m(k, k));
  }
  const Matrix6 scaled = scale.asDiagonal() * m * scale.asDiagonal();
  ldlt.compute(scaled);
  return ldlt.info() == Eigen::Success && ldlt.vectorD().minCoeff() > kSingular;
}

}  // namespace

bool judge_sight(const MotionSight& sight, const StereoEyes& eyes, const RigidMotion& now_from_then,
                 SightError& error) {
  const cv::Vec3d turned = now_from_then.rotation * sight.point_m;
  error.point_now_m = turned + now_from_then.way_m;
  if (error.point_now_m[2] < kNearestSeen_m) return false;
  error.residual_px = sight.now - sight_of(eyes, error.point_now_m);
  // How the sight moves with a pixel of the disparity then: the point moves along its ray.
  const cv::Vec3d along =
      sight_slope(eyes, error.point_now_m) * (turned * (sight.then_noise / sight.disparity_px));
  // The inverse of 1 + along along', after Sherman and Morrison.
  const double share = 1.0 / (1.0 + along.dot(along));
  const double weight = 1.0 / (sight.noise_px * sight.noise_px);
  error.weight = (cv::Matx33d::eye() - along * along.t() * share) * weight;
  error.squared = error.residual_px.dot(error.weight * error.residual_px);
  return true;
}

void StepEquations::add(const SightError& error, const StereoEyes& eyes, double weight) {
  const cv::Matx<double, 3, 6> jacobian = pose_slope(eyes, error.point_now_m);
  const cv::Matx<double, 3, 6> weighed = error.weight * jacobian * weight;
  for (int i = 0; i < 6; ++i) {
    for (int k = i; k < 6; ++k) {
      const double sum = jacobian(0, i) * weighed(0, k) + jacobian(1, i) * weighed(1, k) +
                         jacobian(2, i) * weighed(2, k);
      information(i, k) += sum;
      if (k > i) information(k, i) += sum;
    }
    pull[i] += weighed(0, i) * error.residual_px[0] + weighed(1, i) * error.residual_px[1] +
               weighed(2, i) * error.residual_px[2];
  }
}

bool StepEquations::solve(cv::Vec6d& step) const {
  Eigen::LDLT<Matrix6> ldlt;
  Vector6 scale;
  if (!decompose(information, ldlt, scale)) return false;
  const Eigen::Map<const Vector6> b(pull.val);
  Eigen::Map<Vector6>(step.val) = scale.cwiseProduct(ldlt.solve(scale.cwiseProduct(Vector6(b))));
  for (int k = 0; k < 6; ++k) {
    if (!std::isfinite(step[k])) return false;
  }
  return true;
}

bool invert(const cv::Matx66d& information, cv::Matx66d& covariance) {
  Eigen::LDLT<Matrix6> ldlt;
  Vector6 scale;
  if (!decompose(information, ldlt, scale)) return false;
  const Matrix6 inverse = ldlt.solve(Matrix6::Identity());
  Eigen::Map<Matrix6>(covariance.val) = scale.asDiagonal() * inverse * scale.asDiagonal();
  return true;
}

}  // namespace striate::perception
