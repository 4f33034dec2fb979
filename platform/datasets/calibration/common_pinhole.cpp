#include "striate/platform/datasets/calibration/common_pinhole.hpp"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/lens_rays.hpp"

namespace striate::datasets {
namespace {

/// Rays to points along the picture's edge, turned into the raw camera's frame. Empty: one of them
/// looks backwards.
std::vector<cv::Point2d> edge_rays(const cv::Matx33d& turn, const cv::Matx33d& pinhole,
                                   cv::Size size) {
  constexpr int kOnASide = 16;  // points: an edge bends slowly (ours)
  const cv::Matx33d back = turn.t() * pinhole.inv();
  std::vector<cv::Point2d> rays;
  for (int k = 0; k < kOnASide; ++k) {
    const double u = (size.width - 1.0) * k / (kOnASide - 1);
    const double v = (size.height - 1.0) * k / (kOnASide - 1);
    for (const cv::Point2d& pixel : {cv::Point2d(u, 0.0), cv::Point2d(u, size.height - 1.0),
                                     cv::Point2d(0.0, v), cv::Point2d(size.width - 1.0, v)}) {
      const cv::Vec3d ray = back * cv::Vec3d(pixel.x, pixel.y, 1.0);
      if (ray[2] < 1e-3) return {};
      rays.emplace_back(ray[0] / ray[2], ray[1] / ray[2]);
    }
  }
  return rays;
}

}  // namespace

cv::Matx33d pinhole_of(double focal_px, cv::Point2d middle, cv::Size size) {
  return {focal_px, 0.0,      0.5 * (size.width - 1) - focal_px * middle.x,
          0.0,      focal_px, 0.5 * (size.height - 1) - focal_px * middle.y,
          0.0,      0.0,      1.0};
}

double widest_focal_px(const std::vector<TurnedEye>& eyes, cv::Point2d middle, cv::Size size) {
  const auto fits = [&](double focal_px) {
    return std::ranges::all_of(eyes, [&](const TurnedEye& one) {
      const auto rays = edge_rays(one.turn, pinhole_of(focal_px, middle, size), size);
      return !rays.empty() && all_seen(*one.eye, rays);
    });
  };
  const double usual_px = eyes.front().eye->matrix(0, 0);
  double long_px = 8.0 * usual_px;  // an eighth of the picture is left (ours)
  double short_px = 0.1 * usual_px;
  if (!fits(long_px)) {
    throw UserError(
        "the calibration leaves nothing that both eyes see\n    hint: are R and T of these two "
        "cameras, and the lens's coefficients in the order k1 k2 p1 p2 k3?");
  }
  for (int k = 0; k < 40; ++k) {  // halvings: far below a hundredth of a pixel
    const double between_px = 0.5 * (long_px + short_px);
    (fits(between_px) ? long_px : short_px) = between_px;
  }
  return long_px;
}

std::pair<cv::Matx33d, cv::Matx33d> side_by_side(const EyesApart& apart) {
  cv::Vec3d turn;
  cv::Rodrigues(apart.rotation, turn);
  cv::Matx33d half;
  cv::Rodrigues(-0.5 * turn, half);
  const cv::Matx33d left = half.t();
  const cv::Matx33d& right = half;
  const cv::Vec3d along = right * apart.translation_m;
  // x goes from the left eye to the right one; t points from right to left in the right one's frame
  const cv::Vec3d x = -along / cv::norm(along);
  cv::Vec3d y = cv::Vec3d(0.0, 0.0, 1.0).cross(x);
  y /= cv::norm(y);
  const cv::Vec3d z = x.cross(y);
  const cv::Matx33d level(x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]);
  return {level * left, level * right};
}

}  // namespace striate::datasets
