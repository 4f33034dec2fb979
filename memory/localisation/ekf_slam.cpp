#include "striate/memory/localisation/ekf_slam.hpp"

#include <Eigen/Core>
#include <cmath>

#include "striate/memory/localisation/slam_measurement.hpp"

namespace striate::memory {

using namespace slam_state;

namespace {

/// By hand: the errors of the odometry are not quite constant: so much of them changes in ten
/// metres.
constexpr double kWanderShare = 0.1;
constexpr double kWanderEvery_m = 10.0;

using Robot = Eigen::Matrix<double, EkfSlam::kRobot, EkfSlam::kRobot>;

}  // namespace

void EkfSlam::start(const Pose2& pose) {
  landmarks_ = 0;
  state_.assign(kMost, 0.0);
  covariance_.assign(static_cast<std::size_t>(kMost) * kMost, 0.0);
  gain_.assign(static_cast<std::size_t>(kMost) * 2, 0.0);
  state_[0] = pose.x_m;
  state_[1] = pose.y_m;
  state_[2] = pose.heading_rad;
  Square all = square(covariance_);
  all(3, 3) = settings_.way_error * settings_.way_error;
  all(4, 4) = settings_.turn_error * settings_.turn_error;
  all(5, 5) = settings_.drift_rad_m * settings_.drift_rad_m;
}

void EkfSlam::predict(const Pose2& step) {
  const double way_m = std::hypot(step.x_m, step.y_m);
  if (way_m == 0.0 && step.heading_rad == 0.0) return;
  const double c = std::cos(state_[2]);
  const double s = std::sin(state_[2]);
  const double scale = 1.0 - state_[3];
  const Point odometry(c * step.x_m - s * step.y_m, s * step.x_m + c * step.y_m);
  state_[0] += scale * odometry.x();
  state_[1] += scale * odometry.y();
  state_[2] = wrap_angle(state_[2] + (1.0 - state_[4]) * step.heading_rad - state_[5] * step.x_m);

  Robot by_state = Robot::Identity();
  by_state(0, 2) = -scale * odometry.y();
  by_state(1, 2) = scale * odometry.x();
  by_state(0, 3) = -odometry.x();
  by_state(1, 3) = -odometry.y();
  by_state(2, 4) = -step.heading_rad;
  by_state(2, 5) = -step.x_m;
  Square all = square(covariance_);
  const Robot robot = all.topLeftCorner<kRobot, kRobot>();
  all.topLeftCorner<kRobot, kRobot>() = by_state * robot * by_state.transpose();
  for (int column = kRobot; column < used(); ++column) {
    const Eigen::Matrix<double, kRobot, 1> old = all.block<kRobot, 1>(0, column);
    all.block<kRobot, 1>(0, column) = by_state * old;
    all.block<1, kRobot>(column, 0) = all.block<kRobot, 1>(0, column).transpose();
  }
  const double slip_m2 = settings_.slip_m_root_m * settings_.slip_m_root_m * way_m;
  all(0, 0) += slip_m2;
  all(1, 1) += slip_m2;
  all(2, 2) +=
      settings_.slip_rad_root_m * settings_.slip_rad_root_m * (way_m + std::abs(step.heading_rad));
  const double wander = kWanderShare * kWanderShare * way_m / kWanderEvery_m;
  all(3, 3) += wander * settings_.way_error * settings_.way_error;
  all(4, 4) += wander * settings_.turn_error * settings_.turn_error;
  all(5, 5) += wander * settings_.drift_rad_m * settings_.drift_rad_m;
}

int EkfSlam::add_seen(const Seen& seen) {
  const int added = add_known({});
  if (added < 0) return added;
  const int row = row_of(added);
  const Pose2 robot = pose();
  const Point2 place = transform(robot, Point2{seen.x_m, seen.y_m});
  state_[static_cast<std::size_t>(row)] = place.x_m;
  state_[static_cast<std::size_t>(row) + 1] = place.y_m;
  Eigen::Matrix<double, 2, 3> by_pose;
  by_pose << 1.0, 0.0, robot.y_m - place.y_m, 0.0, 1.0, place.x_m - robot.x_m;
  const Eigen::Matrix2d turn = turn_to_robot(robot.heading_rad).transpose();
  Square all = square(covariance_);
  for (int column = 0; column < row; ++column) {
    const Eigen::Vector3d old = all.block<3, 1>(0, column);
    all.block<2, 1>(row, column) = by_pose * old;
    all.block<1, 2>(column, row) = all.block<2, 1>(row, column).transpose();
  }
  const Eigen::Matrix3d spread = all.topLeftCorner<3, 3>();
  all.block<2, 2>(row, row) =
      by_pose * spread * by_pose.transpose() + turn * covariance_of(seen) * turn.transpose();
  return added;
}

int EkfSlam::add_known(const MapPosition& place) {
  if (landmarks_ >= kLandmarks) return -1;
  const int row = row_of(landmarks_);
  ++landmarks_;
  state_[static_cast<std::size_t>(row)] = place.x_m;
  state_[static_cast<std::size_t>(row) + 1] = place.y_m;
  Square all = square(covariance_);
  all.block(0, row, row + 2, 2).setZero();
  all.block(row, 0, 2, row).setZero();
  all.block<2, 2>(row, row) = covariance_of(place);
  return landmarks_ - 1;
}

void EkfSlam::remove(int landmark) {
  const int row = row_of(landmark);
  const int last = row_of(landmarks_ - 1);
  Square all = square(covariance_);
  if (row != last) {
    for (int k = 0; k < 2; ++k) {
      state_[static_cast<std::size_t>(row + k)] = state_[static_cast<std::size_t>(last + k)];
      for (int column = 0; column < used(); ++column) {
        all(row + k, column) = all(last + k, column);
      }
    }
    for (int k = 0; k < 2; ++k) {
      for (int line = 0; line < used(); ++line) all(line, row + k) = all(line, last + k);
    }
  }
  --landmarks_;
}

double EkfSlam::distance2(int landmark, const Seen& seen) const {
  const int row = row_of(landmark);
  return mahalanobis2(square(covariance_), row, against(state_, row, seen));
}

void EkfSlam::update(int landmark, const Seen& seen) {
  const int row = row_of(landmark);
  Correction<2>{state_, covariance_, gain_, used()}.apply(row, against(state_, row, seen));
}

double EkfSlam::distance2(int landmark, const SeenBearing& seen) const {
  const int row = row_of(landmark);
  return mahalanobis2(square(covariance_), row, against(state_, row, seen));
}

void EkfSlam::update(int landmark, const SeenBearing& seen) {
  const int row = row_of(landmark);
  Correction<1>{state_, covariance_, gain_, used()}.apply(row, against(state_, row, seen));
}

double EkfSlam::distance2_to(int landmark, const MapPosition& known) const {
  const int row = row_of(landmark);
  return mahalanobis2(square(covariance_), row, against_known(state_, row, known));
}

void EkfSlam::fuse(int landmark, const MapPosition& known) {
  const int row = row_of(landmark);
  Correction<2>{state_, covariance_, gain_, used()}.apply(row, against_known(state_, row, known));
}

PoseCovariance EkfSlam::pose_covariance() const {
  const ConstSquare all = square(covariance_);
  PoseCovariance pose{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pose[static_cast<std::size_t>(3 * row + column)] = all(row, column);
    }
  }
  return pose;
}

MapPosition EkfSlam::place(int landmark) const {
  const int row = row_of(landmark);
  const auto at = static_cast<std::size_t>(row);
  return position({state_[at], state_[at + 1]}, square(covariance_).block<2, 2>(row, row));
}

MapPosition EkfSlam::place_from_robot(int landmark) const {
  const int row = row_of(landmark);
  const auto at = static_cast<std::size_t>(row);
  const ConstSquare all = square(covariance_);
  const Covariance mixed = all.block<2, 2>(0, row);
  return position({state_[at], state_[at + 1]},
                  all.block<2, 2>(row, row) + all.block<2, 2>(0, 0) - mixed - mixed.transpose());
}

MapPosition EkfSlam::from_robot(const MapPosition& known) const {
  const ConstSquare all = square(covariance_);
  return position(point_of(known), covariance_of(known) + all.block<2, 2>(0, 0));
}

}  // namespace striate::memory
