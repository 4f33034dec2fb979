#include "striate/memory/localisation/ekf_slam.hpp"
#include "striate/memory/localisation/slam_state.hpp"

namespace striate::memory {

using slam_state::Point;
using slam_state::Square;
using slam_state::square;
using slam_state::turn_to_robot;

void EkfSlam::change_frame(const Pose2& frame, const PoseCovariance& covariance) {
  Square all = square(covariance_);
  const Eigen::Matrix2d turn = turn_to_robot(frame.heading_rad).transpose();
  const auto each_point = [&](auto work) {
    work(0);
    for (int k = 0; k < landmarks_; ++k) work(row_of(k));
  };
  each_point([&](int row) {
    for (int column = 0; column < used(); ++column) {
      const Point old = all.block<2, 1>(row, column);
      all.block<2, 1>(row, column) = turn * old;
    }
  });
  each_point([&](int row) {
    for (int line = 0; line < used(); ++line) {
      const Eigen::RowVector2d old = all.block<1, 2>(line, row);
      all.block<1, 2>(line, row) = old * turn.transpose();
    }
    const auto at = static_cast<std::size_t>(row);
    const Point2 place = transform(frame, Point2{state_[at], state_[at + 1]});
    state_[at] = place.x_m;
    state_[at + 1] = place.y_m;
  });
  state_[2] = wrap_angle(state_[2] + frame.heading_rad);

  // The doubt about the frame, which all points share: rows of J, then P += J C J^T.
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> doubt(covariance.data());
  const auto by_frame = [&](int row) {
    if (row == 2) return Eigen::RowVector3d(0.0, 0.0, 1.0);
    if (row < kRobot && row > 2) return Eigen::RowVector3d(0.0, 0.0, 0.0);
    const auto at = static_cast<std::size_t>(row);
    const bool is_x = row == 0 || (row >= kRobot && (row - kRobot) % 2 == 0);
    return is_x ? Eigen::RowVector3d(1.0, 0.0, frame.y_m - state_[at + 1])
                : Eigen::RowVector3d(0.0, 1.0, state_[at - 1] - frame.x_m);
  };
  for (int column = 0; column < used(); ++column) {
    const Eigen::Vector3d spread = doubt * by_frame(column).transpose();
    for (int row = 0; row < used(); ++row) all(row, column) += by_frame(row).dot(spread);
  }
}

}  // namespace striate::memory
