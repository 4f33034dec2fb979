#include "striate/perception/saliency/blob_response.hpp"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/perception/saliency/gaussian.hpp"

namespace striate::perception {
namespace {

/// Gaussian of `sigma_px` at the working size, for a plane that is `factor` times smaller.
Gaussian gaussian(double sigma_px, double factor) {
  // Averaging n pixels to one adds a variance of (n^2 - 1) / 12; bilinear growing back to half
  // size adds about as much as its triangle kernel, n^2 / 6 between samples, less what half has.
  const double averaged = (factor * factor - 1.0) / 12.0;
  const double grown = factor > 2.0 ? factor * factor / 6.0 : 0.0;
  return Gaussian(std::sqrt(sigma_px * sigma_px - averaged - grown) / factor);
}

cv::Mat1f blur(const cv::Mat1f& plane, const Gaussian& gaussian) {
  cv::Mat1f out;
  gaussian.blur(plane, out);
  return out;
}

cv::Mat1f shrink(const cv::Mat1f& plane) {
  cv::Mat1f out;
  cv::resize(plane, out, {(plane.cols + 1) / 2, (plane.rows + 1) / 2}, 0, 0, cv::INTER_AREA);
  return out;
}

cv::Mat1f grow(const cv::Mat1f& plane, cv::Size size) {
  cv::Mat1f out;
  cv::resize(plane, out, size, 0, 0, cv::INTER_LINEAR);
  return out;
}

}  // namespace

void add_blob_response(const cv::Mat1f& plane, Rectify rectify, cv::Mat1f& sum) {
  static const Gaussian k5 = gaussian(5.0, 2.0);
  static const Gaussian k10 = gaussian(10.0, 4.0);
  static const Gaussian k20 = gaussian(20.0, 8.0);
  static const Gaussian k40 = gaussian(40.0, 8.0);
  const cv::Mat1f quarter = shrink(plane);
  const cv::Mat1f eighth = shrink(quarter);
  const std::array<cv::Mat1f, 4> blurred{blur(plane, k5), grow(blur(quarter, k10), plane.size()),
                                         grow(blur(eighth, k20), plane.size()),
                                         grow(blur(eighth, k40), plane.size())};
  for (int v = 0; v < plane.rows; ++v) {
    float* out = sum[v];
    for (int scale = 0; scale < 3; ++scale) {
      const float* narrow = blurred[scale][v];
      const float* wide = blurred[scale + 1][v];
      for (int u = 0; u < plane.cols; ++u) {
        const float response = narrow[u] - wide[u];
        out[u] += rectify == Rectify::both ? std::abs(response) : std::max(0.0F, response);
      }
    }
  }
}

}  // namespace striate::perception
