#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "tests/reference/saliency_reference.hpp"

/// The robust channels of salience as their formulas say, plainly and in double precision.
namespace striate::reference {

using Energy = std::array<cv::Mat1d, 8>;

/// Means of blocks of 4x4 px; those at the right and lower border may be smaller.
inline cv::Mat1d block_means(const cv::Mat1d& plane) {
  cv::Mat1d means((plane.rows + 3) / 4, (plane.cols + 3) / 4);
  for (int v = 0; v < means.rows; ++v) {
    for (int u = 0; u < means.cols; ++u) {
      const cv::Rect block = cv::Rect(4 * u, 4 * v, 4, 4) & cv::Rect({0, 0}, plane.size());
      means(v, u) = cv::mean(plane(block))[0];
    }
  }
  return means;
}

inline cv::Mat1d texture_channel(const Energy& energy) {
  cv::Mat1d sum(energy[0].size(), 0.0);
  for (const cv::Mat1d& plane : energy) {
    for (const double sigma : {1.0, 2.0}) {
      const cv::Mat1d narrow = gaussian(plane, sigma);
      const cv::Mat1d wide = gaussian(plane, 3.0 * sigma);
      for (int v = 0; v < sum.rows; ++v) {
        for (int u = 0; u < sum.cols; ++u) sum(v, u) += std::max(0.0, narrow(v, u) - wide(v, u));
      }
    }
  }
  return sum;
}

inline cv::Mat1d shape_channel(const Energy& energy) {
  cv::Mat1d sum(energy[0].size(), 0.0);
  for (int i = 0; i < 8; ++i) {
    const cv::Mat1d& plane = energy[static_cast<std::size_t>(i)];
    const double theta = i * 3.14159265358979323846 / 8.0;
    const auto at = [&](int v, int u) {
      return plane(mirror(v, plane.rows), mirror(u, plane.cols));
    };
    for (const double r : {2.0, 4.0, 6.0}) {
      const int du = static_cast<int>(std::lround(r * std::cos(theta)));
      const int dv = static_cast<int>(std::lround(r * std::sin(theta)));
      for (int v = 0; v < sum.rows; ++v) {
        for (int u = 0; u < sum.cols; ++u) {
          sum(v, u) += std::min(at(v + dv, u + du), at(v - dv, u - du));
        }
      }
    }
  }
  return sum;
}

/// |now - before moved by `shift`| less twice its median, where both images show it, else 0 less
/// that. `shift`: the one of all up to 6 px (a quarter of the side at most) with the least mean
/// difference at every second pixel of what both show; of equals the first, no shift before all.
inline cv::Mat1d motion_channel(const cv::Mat1d& now, const cv::Mat1d& before, cv::Point& shift) {
  const auto mean_difference = [&](cv::Point s) {
    double sum = 0.0;
    int count = 0;
    for (int v = std::max(0, -s.y); v < now.rows - std::max(0, s.y); v += 2) {
      for (int u = std::max(0, -s.x); u < now.cols - std::max(0, s.x); u += 2, ++count) {
        sum += std::abs(now(v, u) - before(v + s.y, u + s.x));
      }
    }
    return sum / count;
  };
  shift = {0, 0};
  const int most_u = std::min(6, now.cols / 4), most_v = std::min(6, now.rows / 4);
  for (int dv = -most_v; dv <= most_v; ++dv) {
    for (int du = -most_u; du <= most_u; ++du) {
      if (mean_difference({du, dv}) < mean_difference(shift)) shift = {du, dv};
    }
  }
  const cv::Rect all({0, 0}, now.size());
  cv::Mat1d change(now.size(), 0.0);
  for (int v = 0; v < now.rows; ++v) {
    for (int u = 0; u < now.cols; ++u) {
      const cv::Point was = cv::Point(u, v) + shift;
      if (all.contains(was)) change(v, u) = std::abs(now(v, u) - before(was));
    }
  }
  std::vector<double> sorted(change.begin(), change.end());
  std::sort(sorted.begin(), sorted.end());
  const double noise = 2.0 * sorted[sorted.size() / 2];
  for (double& value : change) value = std::max(0.0, value - noise);
  return change;
}

}  // namespace striate::reference
