#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "striate/memory/localisation/slam_state.hpp"

/// What EkfSlam measures, and what follows from it for all that it knows.
namespace striate::memory::slam_state {

/// A measurement, linear about the state: what differs from what was expected, how it depends on
/// the pose and on the landmark, and the covariance of its own error.
template <int Rows>
struct Measured {
  Eigen::Matrix<double, Rows, 1> difference;
  Eigen::Matrix<double, Rows, 3> by_pose;
  Eigen::Matrix<double, Rows, 2> by_landmark;
  Eigen::Matrix<double, Rows, Rows> error;
};

template <int Rows>
Eigen::Matrix<double, Rows, Rows> expected_covariance(const ConstSquare& all, int row,
                                                      const Measured<Rows>& m) {
  const auto pose = all.block<3, 3>(0, 0);
  const auto mixed = all.block<3, 2>(0, row);
  const auto place = all.block<2, 2>(row, row);
  Eigen::Matrix<double, Rows, Rows> spread = m.error;
  spread += m.by_pose * pose * m.by_pose.transpose();
  const Eigen::Matrix<double, Rows, Rows> cross = m.by_pose * mixed * m.by_landmark.transpose();
  spread += cross + cross.transpose();
  spread += m.by_landmark * place * m.by_landmark.transpose();
  return spread;
}

template <int Rows>
double mahalanobis2(const ConstSquare& all, int row, const Measured<Rows>& m) {
  return m.difference.dot(expected_covariance(all, row, m).llt().solve(m.difference));
}

/// What follows from a measurement for the whole state.
template <int Rows>
struct Correction {
  std::vector<double>& state;
  std::vector<double>& covariance;
  std::vector<double>& gain;
  int used;

  /// P -= L L^T with L = P H^T chol(S)^-T: symmetric to the last bit.
  void apply(int row, const Measured<Rows>& m) const {
    Square all = square(covariance);
    const Eigen::LLT<Eigen::Matrix<double, Rows, Rows>> root(
        expected_covariance(ConstSquare(covariance.data()), row, m));
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Rows>> left(gain.data(), used, Rows);
    left.noalias() = all.block(0, 0, used, 3).lazyProduct(m.by_pose.transpose());
    left.noalias() += all.block(0, row, used, 2).lazyProduct(m.by_landmark.transpose());
    root.matrixU().template solveInPlace<Eigen::OnTheRight>(left);
    const Eigen::Matrix<double, Rows, 1> scaled = root.matrixL().solve(m.difference);
    Eigen::Map<Eigen::VectorXd> x(state.data(), used);
    x.noalias() += left.lazyProduct(scaled);
    x[2] = wrap_angle(x[2]);
    all.topLeftCorner(used, used).noalias() -= left.lazyProduct(left.transpose());
  }
};

/// A landmark that is seen with a range, seen without one, and known from elsewhere.
Measured<2> against(const std::vector<double>& state, int row, const MapPosition& seen);
Measured<1> against(const std::vector<double>& state, int row, const SeenBearing& seen);
Measured<2> against_known(const std::vector<double>& state, int row, const MapPosition& known);

}  // namespace striate::memory::slam_state
