#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

namespace striate::perception {

inline constexpr double kNearestSeen_m = 1e-3;  // before the lens nothing is seen (by hand)
/// Chi squared where a sight's weight is half (Cauchy): the 95 % quantile of three numbers (by
/// hand)
inline constexpr double kCauchyChi3 = 8.0;

/// Two ideal cameras side by side. Camera frame: x right, y down, z forward, from the left eye.
struct StereoEyes {
  double focal_px = 0.0;     ///< > 0
  double centre_u_px = 0.0;  ///< of the left eye
  double centre_v_px = 0.0;  ///< of both
  double baseline_m = 0.0;   ///< > 0
  double doffs_px = 0.0;     ///< how far right of the left one's the right principal point lies
  friend bool operator==(const StereoEyes&, const StereoEyes&) = default;
};

/// A rectified pair of any size.
struct StereoView {
  cv::Mat1b left;
  cv::Mat1b right;  ///< of the same size
  StereoEyes eyes;
};

/// Where both eyes see a point: u, v in the left image and the disparity as it were with both
/// principal points in one column, f B / z.
using StereoSight = cv::Vec3d;

[[nodiscard]] inline StereoSight sight_of(const StereoEyes& eyes, const cv::Vec3d& point_m) {
  const double scale = eyes.focal_px / point_m[2];
  return {scale * point_m[0] + eyes.centre_u_px, scale * point_m[1] + eyes.centre_v_px,
          scale * eyes.baseline_m};
}

/// @param sight its disparity is > 0.
[[nodiscard]] inline cv::Vec3d point_of(const StereoEyes& eyes, const StereoSight& sight) {
  const double scale = eyes.baseline_m / sight[2];
  return {(sight[0] - eyes.centre_u_px) * scale, (sight[1] - eyes.centre_v_px) * scale,
          eyes.focal_px * scale};
}

/// d(u, v, disparity) / d(x, y, z)
[[nodiscard]] inline cv::Matx33d sight_slope(const StereoEyes& eyes, const cv::Vec3d& point_m) {
  const double a = eyes.focal_px / point_m[2];
  const double b = a / point_m[2];
  return {a, 0.0, -b * point_m[0], 0.0, a, -b * point_m[1], 0.0, 0.0, -b * eyes.baseline_m};
}

/// d(u, v, disparity) / d(step) of the pose by which the point is seen, as nudged() takes it.
[[nodiscard]] inline cv::Matx<double, 3, 6> pose_slope(const StereoEyes& eyes,
                                                       const cv::Vec3d& point_m) {
  const cv::Matx33d slope = sight_slope(eyes, point_m);
  const cv::Vec3d& p = point_m;
  const cv::Matx33d turned =
      slope * cv::Matx33d(0, p[2], -p[1], -p[2], 0, p[0], p[1], -p[0], 0);  // -[p]x
  cv::Matx<double, 3, 6> both;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      both(i, k) = slope(i, k);
      both(i, k + 3) = turned(i, k);
    }
  }
  return both;
}

/// @throws std::invalid_argument for a number that is not finite, a focal length or baseline that
/// is not above 0, empty images and eyes of different size
void check_view(const StereoView& view);

/// The view at this width, where it is wider; pixel centres stay where they are. 0: as it is.
[[nodiscard]] StereoView narrowed(const StereoView& view, int width_px);

}  // namespace striate::perception
