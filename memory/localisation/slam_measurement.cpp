#include "striate/memory/localisation/slam_measurement.hpp"

#include <algorithm>
#include <cmath>

namespace striate::memory::slam_state {
namespace {

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

}  // namespace

Measured<2> against(const std::vector<double>& state, int row, const MapPosition& seen) {
  Measured<2> m = expect(state, row);
  m.difference = point_of(seen) - m.difference;
  m.error = covariance_of(seen);
  return m;
}

Measured<1> against(const std::vector<double>& state, int row, const SeenBearing& seen) {
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
  m.error = covariance_of(known);
  return m;
}

}  // namespace striate::memory::slam_state
