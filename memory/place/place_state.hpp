#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "memory/place/place_filter.hpp"

/// How PlaceFilter keeps its Gaussian: a square as wide as it may become, and points of it.
namespace striate::place_state {

constexpr int kMost = PlaceFilter::kRobot + 2 * PlaceFilter::kLandmarks;

using Square = Eigen::Map<Eigen::Matrix<double, kMost, kMost>>;
using ConstSquare = Eigen::Map<const Eigen::Matrix<double, kMost, kMost>>;
using Point = Eigen::Vector2d;
using Spread = Eigen::Matrix2d;

inline Square square(std::vector<double>& values) {
  return Square(values.data());
}

inline ConstSquare square(const std::vector<double>& values) {
  return ConstSquare(values.data());
}

inline Point point_of(const MapPosition& place) {
  return {place.x_m, place.y_m};
}

inline Spread spread_of(const MapPosition& place) {
  Spread spread;
  spread << place.var_x_m2, place.cov_xy_m2, place.cov_xy_m2, place.var_y_m2;
  return spread;
}

inline MapPosition position(const Point& point, const Spread& spread) {
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

}  // namespace striate::place_state
