#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/percept.hpp"

/// Saliency as the paper writes it, plainly: six colour maps at full size, CIE formulas, Gaussians
/// by direct sums in double precision, mirrored borders. Slow; for comparison only.
namespace striate::reference {

inline double linear_light(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

inline double lab_curve(double t) {
  return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
}

/// CIE L*a*b* of a BGR image, white point D65.
inline std::vector<cv::Mat1d> lab_planes(const cv::Mat3b& image) {
  std::vector<cv::Mat1d> planes(3);
  for (cv::Mat1d& plane : planes) plane.create(image.size());
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double b = linear_light(image(v, u)[0] / 255.0);
      const double g = linear_light(image(v, u)[1] / 255.0);
      const double r = linear_light(image(v, u)[2] / 255.0);
      const double x = (0.412453 * r + 0.357580 * g + 0.180423 * b) / 0.950456;
      const double y = 0.212671 * r + 0.715160 * g + 0.072169 * b;
      const double z = (0.019334 * r + 0.119193 * g + 0.950227 * b) / 1.088754;
      planes[0](v, u) = 116.0 * lab_curve(y) - 16.0;
      planes[1](v, u) = 500.0 * (lab_curve(x) - lab_curve(y));
      planes[2](v, u) = 200.0 * (lab_curve(y) - lab_curve(z));
    }
  }
  return planes;
}

inline int mirror(int i, int n) {
  while (i < 0 || i >= n) i = i < 0 ? -i - 1 : 2 * n - 1 - i;
  return i;
}

inline cv::Mat1d gaussian(const cv::Mat1d& in, double sigma) {
  const int radius = static_cast<int>(std::ceil(4.0 * sigma));
  std::vector<double> kernel(2 * radius + 1);
  double total = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    total += kernel[i + radius] = std::exp(-0.5 * i * i / (sigma * sigma));
  }
  cv::Mat1d rows(in.size(), 0.0);
  cv::Mat1d out(in.size(), 0.0);
  for (int v = 0; v < in.rows; ++v) {
    for (int u = 0; u < in.cols; ++u) {
      for (int i = -radius; i <= radius; ++i) {
        rows(v, u) += kernel[i + radius] / total * in(v, mirror(u + i, in.cols));
      }
    }
  }
  for (int v = 0; v < in.rows; ++v) {
    for (int u = 0; u < in.cols; ++u) {
      for (int i = -radius; i <= radius; ++i) {
        out(v, u) += kernel[i + radius] / total * rows(mirror(v + i, in.rows), u);
      }
    }
  }
  return out;
}

inline void add_rectified_blobs(const cv::Mat1d& map, cv::Mat1d& sum) {
  for (const double sigma : {5.0, 10.0, 20.0}) {
    const cv::Mat1d narrow = gaussian(map, sigma);
    const cv::Mat1d wide = gaussian(map, 2.0 * sigma);
    for (int v = 0; v < map.rows; ++v) {
      for (int u = 0; u < map.cols; ++u) sum(v, u) += std::max(0.0, narrow(v, u) - wide(v, u));
    }
  }
}

/// Before thresholding; 0..1 if any response reaches `least_contrast`.
inline cv::Mat1d salience(const cv::Mat3b& image, const cv::Mat1f& disparity_px, double near_px,
                          double near_gain, double least_contrast) {
  cv::Mat1d sum(image.size(), 0.0);
  for (const cv::Mat1d& plane : lab_planes(image)) {
    add_rectified_blobs(plane, sum);
    add_rectified_blobs(100.0 - plane, sum);  // the complement: black, green, blue
  }
  if (!disparity_px.empty()) {
    cv::Mat1d near(image.size(), 0.0);
    for (int v = 0; v < near.rows; ++v) {
      for (int u = 0; u < near.cols; ++u) {
        const double d = disparity_px(v, u);
        if (std::isfinite(d) && d > near_px) near(v, u) = near_gain * d;
      }
    }
    add_rectified_blobs(near, sum);
  }
  const double highest = *std::max_element(sum.begin(), sum.end());
  return sum / std::max(highest, least_contrast);
}

}  // namespace striate::reference
