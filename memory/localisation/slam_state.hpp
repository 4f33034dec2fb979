#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "striate/memory/localisation/slam_types.hpp"
#include "striate/memory/long_term/records.hpp"

/// How EkfSlam keeps its Gaussian: a square as wide as it may become, and points of it.
namespace striate::memory::slam_state {

constexpr int kMost = kRobot + 2 * kLandmarks;

using Square = Eigen::Map<Eigen::Matrix<double, kMost, kMost>>;
using ConstSquare = Eigen::Map<const Eigen::Matrix<double, kMost, kMost>>;
using Point = Eigen::Vector2d;
using Covariance = Eigen::Matrix2d;

inline Square square(std::vector<double>& values) {
  return Square(values.data());
}

inline ConstSquare square(const std::vector<double>& values) {
  return ConstSquare(values.data());
}

inline Point point_of(const MapPosition& place) {
  return {place.x_m, place.y_m};
}

inline Covariance covariance_of(const MapPosition& place) {
  Covariance spread;
  spread << place.var_x_m2, place.cov_xy_m2, place.cov_xy_m2, place.var_y_m2;
  return spread;
}

inline MapPosition position(const Point& point, const Covariance& spread) {
  return {point.x(), point.y(), spread(0, 0), 0.5 * (spread(0, 1) + spread(1, 0)), spread(1, 1)};
}

/// From the outer frame into one that is turned by `heading_rad`.
inline Eigen::Matrix2d turn_to_robot(double heading_rad) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  Eigen::Matrix2d turn;
  turn << c, s, -s, c;
  return turn;
}

}  // namespace striate::memory::slam_state
