#pragma once

#include <cmath>

namespace striate {

/// Pi. Not from <numbers>: the interface is read as C++17 too, which ROS 1 still needs.
inline constexpr double kPi = 3.14159265358979323846;

/// A point on the floor. Robot frame: x forward, y left.
struct Point2 {
  double x_m = 0.0;
  double y_m = 0.0;
};

/// A place and heading on the floor; angles counter-clockwise.
struct Pose2 {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
};

[[nodiscard]] constexpr double radians(double degrees) {
  return degrees * kPi / 180.0;
}

[[nodiscard]] constexpr double degrees(double radians) {
  return radians * 180.0 / kPi;
}

/// The same angle within [-pi, pi].
[[nodiscard]] inline double wrap_angle(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * kPi);
}

[[nodiscard]] inline double apart_m(Point2 a, Point2 b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

/// A point given in the frame of `pose`, in the frame that `pose` is given in.
[[nodiscard]] inline Point2 transform(const Pose2& pose, Point2 inner) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  return {pose.x_m + c * inner.x_m - s * inner.y_m, pose.y_m + s * inner.x_m + c * inner.y_m};
}

/// The inverse of `transform`.
[[nodiscard]] inline Point2 inverse_transform(const Pose2& pose, Point2 outer) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  const double dx = outer.x_m - pose.x_m;
  const double dy = outer.y_m - pose.y_m;
  return {c * dx + s * dy, -s * dx + c * dy};
}

[[nodiscard]] inline Pose2 transform(const Pose2& pose, const Pose2& inner) {
  const Point2 p = transform(pose, Point2{inner.x_m, inner.y_m});
  return {p.x_m, p.y_m, wrap_angle(pose.heading_rad + inner.heading_rad)};
}

[[nodiscard]] inline Pose2 inverse_transform(const Pose2& pose, const Pose2& outer) {
  const Point2 p = inverse_transform(pose, Point2{outer.x_m, outer.y_m});
  return {p.x_m, p.y_m, wrap_angle(outer.heading_rad - pose.heading_rad)};
}

}  // namespace striate
