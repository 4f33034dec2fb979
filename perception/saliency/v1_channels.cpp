#include "perception/saliency/v1_channels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace striate {

void average_energy(const V1Responses& v1, cv::Size half, OrientedEnergy& out) {
  const auto scale = static_cast<float>(0.25 / v1.gain);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].create(half);
    for (int v = 0; v < half.height; ++v) {
      const int below = std::min(2 * v + 1, v1.height - 1);
      const std::int16_t* upper = v1.code[i].row(std::min(2 * v, v1.height - 1));
      const std::int16_t* lower = v1.code[i].row(below);
      float* to = out[i][v];
      for (int u = 0; u < half.width; ++u) {
        const int left = std::min(2 * u, v1.width - 1);
        const int right = std::min(2 * u + 1, v1.width - 1);
        to[u] = scale * (complex_response(upper[left]) + complex_response(upper[right]) +
                         complex_response(lower[left]) + complex_response(lower[right]));
      }
    }
  }
}

void add_texture(const OrientedEnergy& energy, double sigma_px, cv::Mat1f& sum) {
  cv::Mat1f narrow;
  cv::Mat1f wide;
  for (const cv::Mat1f& plane : energy) {
    cv::GaussianBlur(plane, narrow, {0, 0}, sigma_px, sigma_px, cv::BORDER_REFLECT);
    // A Gaussian of 3 sigma is the narrow one blurred again by sqrt(9 - 1) sigma.
    const double more_px = std::sqrt(8.0) * sigma_px;
    cv::GaussianBlur(narrow, wide, {0, 0}, more_px, more_px, cv::BORDER_REFLECT);
    for (int v = 0; v < sum.rows; ++v) {
      for (int u = 0; u < sum.cols; ++u) sum(v, u) += std::abs(narrow(v, u) - wide(v, u));
    }
  }
}

void add_shape(const OrientedEnergy& energy, double radius_px, cv::Mat1f& sum) {
  for (std::size_t i = 0; i < energy.size(); ++i) {
    const double theta = static_cast<double>(i) * std::numbers::pi / kOrientations;
    const int du = static_cast<int>(std::lround(radius_px * std::cos(theta)));
    const int dv = static_cast<int>(std::lround(radius_px * std::sin(theta)));
    const int from_u = std::abs(du);
    const int from_v = std::abs(dv);
    for (int v = from_v; v < sum.rows - from_v; ++v) {
      const float* ahead = energy[i][v + dv] + du;
      const float* behind = energy[i][v - dv] - du;
      float* to = sum[v];
      for (int u = from_u; u < sum.cols - from_u; ++u) to[u] += std::min(ahead[u], behind[u]);
    }
  }
}

}  // namespace striate
