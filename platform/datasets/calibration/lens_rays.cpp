#include "striate/platform/datasets/calibration/lens_rays.hpp"

#include <cmath>
#include <opencv2/calib3d.hpp>

namespace striate::datasets {

std::vector<cv::Point2d> shown_at(const EyeModel& eye, const std::vector<cv::Point2d>& rays) {
  std::vector<cv::Point2d> pixels;
  if (rays.empty()) return pixels;
  if (eye.lens == Lens::equidistant) {
    cv::fisheye::distortPoints(rays, pixels, eye.matrix, eye.distortion);
    return pixels;
  }
  std::vector<cv::Point3d> points;
  for (const cv::Point2d& ray : rays) points.emplace_back(ray.x, ray.y, 1.0);
  const cv::Vec3d none{};
  if (eye.distortion.empty()) {
    cv::projectPoints(points, none, none, eye.matrix, cv::noArray(), pixels);
  } else {
    cv::projectPoints(points, none, none, eye.matrix, eye.distortion, pixels);
  }
  return pixels;
}

cv::Point2d ray_of(const EyeModel& eye, cv::Point2d pixel) {
  const std::vector<cv::Point2d> pixels = {pixel};
  std::vector<cv::Point2d> rays;
  if (eye.lens == Lens::equidistant) {
    cv::fisheye::undistortPoints(pixels, rays, eye.matrix, eye.distortion);
  } else if (eye.distortion.empty()) {
    cv::undistortPoints(pixels, rays, eye.matrix, cv::noArray());
  } else {
    cv::undistortPoints(pixels, rays, eye.matrix, eye.distortion);
  }
  return rays.front();
}

bool all_seen(const EyeModel& eye, const std::vector<cv::Point2d>& rays) {
  constexpr int kSteps = 8;  // from the middle outwards; lenses bend slowly (ours)
  const cv::Point2d middle(eye.matrix(0, 2), eye.matrix(1, 2));
  std::vector<double> before(rays.size(), 0.0);
  for (int step = 1; step <= kSteps; ++step) {
    std::vector<cv::Point2d> part;
    for (const cv::Point2d& ray : rays) part.push_back(ray * (static_cast<double>(step) / kSteps));
    const std::vector<cv::Point2d> pixels = shown_at(eye, part);
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const double out_px = cv::norm(pixels[k] - middle);
      const bool inside = pixels[k].x >= 0.0 && pixels[k].y >= 0.0 &&
                          pixels[k].x <= eye.size_px.width - 1 &&
                          pixels[k].y <= eye.size_px.height - 1;
      const bool last = step == kSteps;
      // Near the middle a lens with tangential parts may go aside a little.
      if (!(out_px >= before[k] - 0.5) || (last && !inside)) return false;
      before[k] = out_px;
    }
  }
  return true;
}

}  // namespace striate::datasets
