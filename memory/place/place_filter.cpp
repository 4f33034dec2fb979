#include "memory/place/place_filter.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace striate {
namespace {

constexpr int kMost = PlaceFilter::kRobot + 2 * PlaceFilter::kLandmarks;
/// The errors of the odometry are not quite constant: so much of them changes in ten metres.
constexpr double kWanderShare = 0.1;
constexpr double kWanderEvery_m = 10.0;

using Square = Eigen::Map<Eigen::Matrix<double, kMost, kMost>>;
using ConstSquare = Eigen::Map<const Eigen::Matrix<double, kMost, kMost>>;
using Robot = Eigen::Matrix<double, PlaceFilter::kRobot, PlaceFilter::kRobot>;
using Point = Eigen::Vector2d;
using Spread = Eigen::Matrix2d;

Square square(std::vector<double>& values) {
  return Square(values.data());
}

ConstSquare square(const std::vector<double>& values) {
  return ConstSquare(values.data());
}

Point point_of(const MapPosition& place) {
  return {place.x_m, place.y_m};
}

Spread spread_of(const MapPosition& place) {
  Spread spread;
  spread << place.var_x_m2, place.cov_xy_m2, place.cov_xy_m2, place.var_y_m2;
  return spread;
}

MapPosition position(const Point& point, const Spread& spread) {
  return {point.x(), point.y(), spread(0, 0), 0.5 * (spread(0, 1) + spread(1, 0)), spread(1, 1)};
}

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
Eigen::Matrix<double, Rows, Rows> expected_spread(const ConstSquare& all, int row,
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
  return m.difference.dot(expected_spread(all, row, m).llt().solve(m.difference));
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
        expected_spread(ConstSquare(covariance.data()), row, m));
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

Eigen::Matrix2d turn_to_robot(double heading_rad) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  Eigen::Matrix2d turn;
  turn << c, s, -s, c;
  return turn;
}

/// Where the landmark lies in the robot's frame, and how that depends on pose and landmark.
Measured<2> expect(const std::vector<double>& state, int row) {
  const Eigen::Matrix2d turn = turn_to_robot(state[2]);
  const auto at = static_cast<std::size_t>(row);
  const Point here = turn * Point(state[at] - state[0], state[at + 1] - state[1]);
  Measured<2> m;
  m.difference = here;
  m.by_landmark = turn;
  m.by_pose.leftCols<2>() = -turn;
  m.by_pose.col(2) = Point(here.y(), -here.x());
  m.error.setZero();
  return m;
}

Measured<2> against(const std::vector<double>& state, int row, const MapPosition& seen) {
  Measured<2> m = expect(state, row);
  m.difference = point_of(seen) - m.difference;
  m.error = spread_of(seen);
  return m;
}

Measured<1> against(const std::vector<double>& state, int row,
                    const PlaceFilter::SeenBearing& seen) {
  const Measured<2> here = expect(state, row);
  const Eigen::Matrix2d turn = turn_to_robot(seen.from.heading_rad);
  const Point view = turn * (here.difference - Point(seen.from.x_m, seen.from.y_m));
  const double range2 = std::max(1e-4, view.squaredNorm());
  const Eigen::RowVector2d by_view(-view.y() / range2, view.x() / range2);
  Measured<1> m;
  m.difference[0] = wrap_angle(seen.bearing_rad - std::atan2(view.y(), view.x()));
  m.by_landmark = by_view * turn * here.by_landmark;
  m.by_pose = by_view * turn * here.by_pose;
  m.error(0, 0) = seen.sigma_rad * seen.sigma_rad;
  return m;
}

Measured<2> against_known(const std::vector<double>& state, int row, const MapPosition& known) {
  const auto at = static_cast<std::size_t>(row);
  Measured<2> m;
  m.difference = point_of(known) - Point(state[at], state[at + 1]);
  m.by_pose.setZero();
  m.by_landmark.setIdentity();
  m.error = spread_of(known);
  return m;
}

}  // namespace

void PlaceFilter::start(const Pose2& pose) {
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

void PlaceFilter::predict(const Pose2& step) {
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

int PlaceFilter::add_seen(const Seen& seen) {
  const int added = add_known({});
  if (added < 0) return added;
  const int row = row_of(added);
  const Pose2 robot = pose();
  const Point2 place = to_outer(robot, Point2{seen.x_m, seen.y_m});
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
      by_pose * spread * by_pose.transpose() + turn * spread_of(seen) * turn.transpose();
  return added;
}

int PlaceFilter::add_known(const MapPosition& place) {
  if (landmarks_ >= kLandmarks) return -1;
  const int row = row_of(landmarks_);
  ++landmarks_;
  state_[static_cast<std::size_t>(row)] = place.x_m;
  state_[static_cast<std::size_t>(row) + 1] = place.y_m;
  Square all = square(covariance_);
  all.block(0, row, row + 2, 2).setZero();
  all.block(row, 0, 2, row).setZero();
  all.block<2, 2>(row, row) = spread_of(place);
  return landmarks_ - 1;
}

void PlaceFilter::remove(int landmark) {
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

double PlaceFilter::distance2(int landmark, const Seen& seen) const {
  const int row = row_of(landmark);
  return mahalanobis2(square(covariance_), row, against(state_, row, seen));
}

void PlaceFilter::update(int landmark, const Seen& seen) {
  const int row = row_of(landmark);
  Correction<2>{state_, covariance_, gain_, used()}.apply(row, against(state_, row, seen));
}

double PlaceFilter::distance2(int landmark, const SeenBearing& seen) const {
  const int row = row_of(landmark);
  return mahalanobis2(square(covariance_), row, against(state_, row, seen));
}

void PlaceFilter::update(int landmark, const SeenBearing& seen) {
  const int row = row_of(landmark);
  Correction<1>{state_, covariance_, gain_, used()}.apply(row, against(state_, row, seen));
}

double PlaceFilter::distance2_to(int landmark, const MapPosition& known) const {
  const int row = row_of(landmark);
  return mahalanobis2(square(covariance_), row, against_known(state_, row, known));
}

void PlaceFilter::fuse(int landmark, const MapPosition& known) {
  const int row = row_of(landmark);
  Correction<2>{state_, covariance_, gain_, used()}.apply(row, against_known(state_, row, known));
}

void PlaceFilter::transform(const Pose2& frame, const PoseCovariance& covariance) {
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
    const Point2 place = to_outer(frame, Point2{state_[at], state_[at + 1]});
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

PoseCovariance PlaceFilter::pose_covariance() const {
  const ConstSquare all = square(covariance_);
  PoseCovariance pose{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pose[static_cast<std::size_t>(3 * row + column)] = all(row, column);
    }
  }
  return pose;
}

MapPosition PlaceFilter::place(int landmark) const {
  const int row = row_of(landmark);
  const auto at = static_cast<std::size_t>(row);
  return position({state_[at], state_[at + 1]}, square(covariance_).block<2, 2>(row, row));
}

MapPosition PlaceFilter::place_from_robot(int landmark) const {
  const int row = row_of(landmark);
  const auto at = static_cast<std::size_t>(row);
  const ConstSquare all = square(covariance_);
  const Spread mixed = all.block<2, 2>(0, row);
  return position({state_[at], state_[at + 1]},
                  all.block<2, 2>(row, row) + all.block<2, 2>(0, 0) - mixed - mixed.transpose());
}

MapPosition PlaceFilter::from_robot(const MapPosition& known) const {
  const ConstSquare all = square(covariance_);
  return position(point_of(known), spread_of(known) + all.block<2, 2>(0, 0));
}

}  // namespace striate
