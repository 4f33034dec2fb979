#include "striate/perception/visual_odometry/stereo_eyes.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace striate::perception {

void check_view(const StereoView& view) {
  const StereoEyes& eyes = view.eyes;
  for (const double number :
       {eyes.focal_px, eyes.centre_u_px, eyes.centre_v_px, eyes.baseline_m, eyes.doffs_px}) {
    if (!std::isfinite(number)) {
      throw std::invalid_argument("visual odometry: a number of the camera is not finite");
    }
  }
  if (!(eyes.focal_px > 0.0)) {
    throw std::invalid_argument("visual odometry: the focal length must be above 0 px");
  }
  if (!(eyes.baseline_m > 0.0)) {
    throw std::invalid_argument("visual odometry: the baseline must be above 0 m");
  }
  if (view.left.empty() || view.right.empty()) {
    throw std::invalid_argument("visual odometry needs the images of both eyes");
  }
  if (view.left.size() != view.right.size()) {
    throw std::invalid_argument("visual odometry: the eyes' images differ in size");
  }
}

StereoView narrowed(const StereoView& view, int width_px) {
  if (width_px <= 0 || view.left.cols <= width_px) return view;
  const double scale = static_cast<double>(width_px) / view.left.cols;
  const cv::Size size(width_px, std::max(1, static_cast<int>(std::lround(scale * view.left.rows))));
  StereoView result;
  cv::resize(view.left, result.left, size, 0, 0, cv::INTER_AREA);
  cv::resize(view.right, result.right, size, 0, 0, cv::INTER_AREA);
  // Rows may be scaled by a little else, since there are whole ones; a pixel of a focal length for
  // rows of its own is not worth it: less than half a row over the height.
  const double scale_v = static_cast<double>(size.height) / view.left.rows;
  result.eyes = view.eyes;
  result.eyes.focal_px *= scale;
  result.eyes.doffs_px *= scale;
  result.eyes.centre_u_px = (view.eyes.centre_u_px + 0.5) * scale - 0.5;
  result.eyes.centre_v_px = (view.eyes.centre_v_px + 0.5) * scale_v - 0.5;
  return result;
}

}  // namespace striate::perception
