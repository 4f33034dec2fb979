#include <Eigen/Geometry>

#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::datasets {
namespace {

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;  // as cv::Matx33d keeps it

}  // namespace

cv::Vec4d quaternion_of(const cv::Matx33d& rotation) {
  const Eigen::Quaterniond q(Eigen::Map<const RowMajor3>(rotation.val).eval());
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  return {sign * q.x(), sign * q.y(), sign * q.z(), sign * q.w()};
}

cv::Matx33d rotation_of(cv::Vec4d xyzw) {
  const Eigen::Quaterniond q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  const RowMajor3 rotation = q.normalized().toRotationMatrix();
  return cv::Matx33d(rotation.data());
}

}  // namespace striate::datasets
