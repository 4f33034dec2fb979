#include "striate/perception/visual_odometry/rigid_motion.hpp"

#include <cmath>

namespace striate::perception {
namespace {

constexpr double kNoTurn_rad =
    1e-12;  // below it the series' first term is exact in double precision

}  // namespace

cv::Matx33d rotation_about(const cv::Vec3d& turn_rad) {
  const double angle_rad = std::sqrt(turn_rad.dot(turn_rad));
  const cv::Matx33d cross(0, -turn_rad[2], turn_rad[1], turn_rad[2], 0, -turn_rad[0], -turn_rad[1],
                          turn_rad[0], 0);
  if (angle_rad < kNoTurn_rad) return cv::Matx33d::eye() + cross;
  const double half = std::sin(0.5 * angle_rad) / angle_rad;
  return cv::Matx33d::eye() + cross * (std::sin(angle_rad) / angle_rad) +
         cross * cross * (2.0 * half * half);
}

cv::Vec3d turn_of(const cv::Matx33d& r) {
  // By the quaternion, of which the largest part is found first: exact near 0 and near half a turn.
  const double trace = r(0, 0) + r(1, 1) + r(2, 2);
  cv::Vec4d q(1.0 + trace, r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  if (trace < 0.0) {
    int k = 0;
    for (int i = 1; i < 3; ++i) {
      if (r(i, i) > r(k, k)) k = i;
    }
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    q[0] = r(j, i) - r(i, j);
    q[1 + k] = 1.0 + r(k, k) - r(i, i) - r(j, j);
    q[1 + i] = r(i, k) + r(k, i);
    q[1 + j] = r(j, k) + r(k, j);
  }
  if (q[0] < 0.0) q = -q;
  const cv::Vec3d axis(q[1], q[2], q[3]);
  const double length = std::sqrt(axis.dot(axis));
  if (length < kNoTurn_rad * q[0]) return axis * (2.0 / q[0]);
  return axis * (2.0 * std::atan2(length, q[0]) / length);
}

RigidMotion nudged(const RigidMotion& motion, const cv::Vec6d& step) {
  const cv::Matx33d turn = rotation_about({step[3], step[4], step[5]});
  return {turn * motion.rotation, turn * motion.way_m + cv::Vec3d(step[0], step[1], step[2])};
}

cv::Vec6d step_between(const RigidMotion& a, const RigidMotion& b) {
  const RigidMotion between = a * inverse(b);
  const cv::Vec3d turn_rad = turn_of(between.rotation);
  return {between.way_m[0], between.way_m[1], between.way_m[2],
          turn_rad[0],      turn_rad[1],      turn_rad[2]};
}

RigidMotion straightened(const RigidMotion& motion) {
  return {rotation_about(turn_of(motion.rotation)), motion.way_m};
}

}  // namespace striate::perception
