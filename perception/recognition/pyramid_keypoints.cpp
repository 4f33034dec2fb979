#include "perception/recognition/pyramid_keypoints.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "perception/descriptor/dense_descriptor.hpp"
#include "perception/descriptor/descriptor_points.hpp"

namespace striate {
namespace {

/// The cells that describe, as they are on the halved level.
V1Settings describing_cells(const PyramidSettings& settings) {
  V1Settings cells;
  cells.wavelength_px = settings.descriptor_wavelength_px / 2.0;
  cells.sigma_factor = settings.descriptor_sigma_factor;
  return cells;
}

cv::Mat1b resized(const cv::Mat1b& grey, cv::Size size) {
  if (size == grey.size()) return grey;
  cv::Mat1b result;
  cv::resize(grey, result, size, 0, 0, cv::INTER_AREA);
  return result;
}

}  // namespace

PyramidKeypoints::PyramidKeypoints(const PyramidSettings& settings)
    : settings_(settings), finder_(settings.keypoints), cells_(describing_cells(settings)) {}

std::vector<Keypoint> PyramidKeypoints::operator()(const cv::Mat1b& grey) {
  std::vector<Keypoint> all;
  for (int k = 0; k < settings_.levels; ++k) {
    const double shrink = std::pow(2.0, -0.5 * k);
    const cv::Size size(static_cast<int>(std::lround(grey.cols * shrink)),
                        static_cast<int>(std::lround(grey.rows * shrink)));
    if (k > 0 && std::min(size.width, size.height) < settings_.least_side_px) break;
    const cv::Mat1b level = resized(grey, size);
    std::vector<Keypoint> points = finder_.find(level);
    describe(level, points);
    const double zoom_u = static_cast<double>(grey.cols) / size.width;
    const double zoom_v = static_cast<double>(grey.rows) / size.height;
    for (Keypoint& point : points) {
      point.u_px = (point.u_px + 0.5) * zoom_u - 0.5;
      point.v_px = (point.v_px + 0.5) * zoom_v - 0.5;
      point.wavelength_px *= zoom_u;
      all.push_back(point);
    }
  }
  return all;
}

void PyramidKeypoints::describe(const cv::Mat1b& level, std::vector<Keypoint>& points) {
  const cv::Mat1b half = resized(level, {std::max(1, level.cols / 2), std::max(1, level.rows / 2)});
  const double wavelength_px = settings_.descriptor_wavelength_px / 2.0;
  const auto around = descriptor_points(wavelength_px, 1.0);
  cells_.respond(half, descriptor_reach(wavelength_px, 1.0), false, responses_);
  auto halved = [](double at, int count) {
    return std::clamp(static_cast<int>(std::lround((at + 0.5) / 2 - 0.5)), 0, count - 1);
  };
  for (Keypoint& point : points) {
    point.descriptor = describe_pixel(responses_, around, halved(point.u_px, half.cols),
                                      halved(point.v_px, half.rows));
  }
}

}  // namespace striate
