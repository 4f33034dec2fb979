#include "perception/recognition/pyramid_keypoints.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace striate {

PyramidKeypoints::PyramidKeypoints(const PyramidSettings& settings)
    : settings_(settings), finder_(settings.keypoints) {}

std::vector<Keypoint> PyramidKeypoints::operator()(const cv::Mat1b& grey) {
  std::vector<Keypoint> all;
  for (int k = 0; k < settings_.levels; ++k) {
    const double shrink = std::pow(2.0, -0.5 * k);
    const cv::Size size(static_cast<int>(std::lround(grey.cols * shrink)),
                        static_cast<int>(std::lround(grey.rows * shrink)));
    if (k > 0 && std::min(size.width, size.height) < settings_.least_side_px) break;
    if (k == 0) {
      level_ = grey;
    } else {
      cv::Mat1b smaller;
      cv::resize(grey, smaller, size, 0, 0, cv::INTER_AREA);
      level_ = smaller;
    }
    const double zoom_u = static_cast<double>(grey.cols) / size.width;
    const double zoom_v = static_cast<double>(grey.rows) / size.height;
    for (Keypoint point : finder_.find(level_)) {
      point.u_px = (point.u_px + 0.5) * zoom_u - 0.5;
      point.v_px = (point.v_px + 0.5) * zoom_v - 0.5;
      point.wavelength_px *= zoom_u;
      all.push_back(point);
    }
  }
  return all;
}

}  // namespace striate
