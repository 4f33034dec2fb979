#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::datasets {

cv::Vec4d quaternion_of(const cv::Matx33d& r) {
  // The largest of the four is divided by, so that nothing is lost (Shepperd 1978).
  const double squares[4] = {1.0 + r(0, 0) - r(1, 1) - r(2, 2), 1.0 - r(0, 0) + r(1, 1) - r(2, 2),
                             1.0 - r(0, 0) - r(1, 1) + r(2, 2), 1.0 + r(0, 0) + r(1, 1) + r(2, 2)};
  const auto most = std::max_element(std::begin(squares), std::end(squares)) - squares;
  cv::Vec4d q;
  const double twice = std::sqrt(squares[most]);
  q[static_cast<int>(most)] = 0.5 * twice;
  const double by = 0.5 / twice;
  const double x_w = by * (r(2, 1) - r(1, 2));
  const double y_w = by * (r(0, 2) - r(2, 0));
  const double z_w = by * (r(1, 0) - r(0, 1));
  const double x_y = by * (r(0, 1) + r(1, 0));
  const double x_z = by * (r(0, 2) + r(2, 0));
  const double y_z = by * (r(1, 2) + r(2, 1));
  if (most == 0) q = {q[0], x_y, x_z, x_w};
  if (most == 1) q = {x_y, q[1], y_z, y_w};
  if (most == 2) q = {x_z, y_z, q[2], z_w};
  if (most == 3) q = {x_w, y_w, z_w, q[3]};
  return q[3] < 0.0 ? -q : q;
}

cv::Matx33d rotation_of(cv::Vec4d q) {
  q /= cv::norm(q);
  const double x = q[0];
  const double y = q[1];
  const double z = q[2];
  const double w = q[3];
  return {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
          2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
          2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
}

}  // namespace striate::datasets
