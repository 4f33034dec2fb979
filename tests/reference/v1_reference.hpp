#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "striate/perception/v1/v1_settings.hpp"

/// V1 by the book: direct convolution in double precision, no shortcut. Slow on purpose.
namespace striate::reference {

struct GaborKernel {
  cv::Mat1d even, odd;
};

/// The paper's kernel of orientation i.
inline GaborKernel gabor_kernel(const perception::V1Settings& s, int orientation) {
  const double theta = orientation * std::numbers::pi / 8.0;
  const double lambda = s.wavelength_px;
  const double sigma = s.sigma_factor * lambda;
  int side = static_cast<int>(std::lround(5.0 * lambda));
  if (side % 2 == 0) ++side;
  const int radius = side / 2;
  GaborKernel kernel{cv::Mat1d(side, side), cv::Mat1d(side, side)};
  cv::Mat1d envelope(side, side);
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const double xr = x * std::cos(theta) + y * std::sin(theta);
      const double yr = y * std::cos(theta) - x * std::sin(theta);
      const double g = std::exp(-(xr * xr + s.gamma * yr * yr) / (2.0 * sigma * sigma));
      const double phase = 2.0 * std::numbers::pi * xr / lambda;
      envelope(y + radius, x + radius) = g;
      kernel.even(y + radius, x + radius) = g * std::cos(phase);
      kernel.odd(y + radius, x + radius) = g * std::cos(phase - std::numbers::pi / 2.0);
    }
  }
  if (s.even_mean == perception::EvenMean::flat) kernel.even -= cv::mean(kernel.even)[0];
  if (s.even_mean == perception::EvenMean::envelope) {
    kernel.even -= envelope * (cv::sum(kernel.even)[0] / cv::sum(envelope)[0]);
  }
  return kernel;
}

struct V1Reference {
  std::array<cv::Mat1d, 8> even, odd, energy;  ///< energy = even^2 + odd^2: same order as C
};

/// Responses of all simple and complex cells; the image is mirrored at its border.
/// @param image grey levels 0..255 of any depth; 16 bits count sixteenths, as for V1Cells.
inline V1Reference respond(const cv::Mat& image, const perception::V1Settings& settings) {
  V1Reference result;
  cv::Mat1d grey;
  image.convertTo(grey, CV_64F, image.depth() == CV_16U ? 1.0 / 16.0 : 1.0);
  for (int i = 0; i < 8; ++i) {
    const GaborKernel kernel = gabor_kernel(settings, i);
    const int radius = kernel.even.rows / 2;
    cv::Mat1d wide;
    cv::copyMakeBorder(grey, wide, radius, radius, radius, radius, cv::BORDER_REFLECT_101);
    cv::Mat1d even(grey.size()), odd(grey.size()), energy(grey.size());
    for (int y = 0; y < grey.rows; ++y) {
      for (int x = 0; x < grey.cols; ++x) {
        double sum_even = 0.0, sum_odd = 0.0;
        for (int ky = 0; ky <= 2 * radius; ++ky) {
          for (int kx = 0; kx <= 2 * radius; ++kx) {
            const double value = wide(y + ky, x + kx);
            sum_even += value * kernel.even(ky, kx);
            sum_odd += value * kernel.odd(ky, kx);
          }
        }
        even(y, x) = sum_even;
        odd(y, x) = sum_odd;
        energy(y, x) = sum_even * sum_even + sum_odd * sum_odd;
      }
    }
    const auto at = static_cast<std::size_t>(i);
    result.even[at] = even;
    result.odd[at] = odd;
    result.energy[at] = energy;
  }
  return result;
}

}  // namespace striate::reference
