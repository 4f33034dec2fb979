#include "striate/perception/corridor/edge_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <span>

namespace striate::perception {
namespace {

/// Grey levels per px: a step of 2.5 levels, which the blur makes 0.32 of itself per px
constexpr float kLeastGradient = 0.8F;
/// Of the median: where all is noise (Rayleigh) 1 in 2^(2^2) = 16 pixels exceeds it
constexpr float kOverMedian = 2.0F;
/// Grey levels per px: a step of 15 levels is an edge in any texture (ours)
constexpr float kHighestFloor = 5.0F;
/// Times the threshold: three medians, which 1 in 2^(3^2) = 512 pixels of noise exceeds
constexpr float kFullWeight = 1.5F;

/// px: a smaller image has no pixel whose neighbourhood lies inside it
constexpr int kSmallestSide_px = 8;

struct Gradients {
  cv::Mat1f along_u;
  cv::Mat1f along_v;
  cv::Mat1f magnitude;
};

Gradients differentiate(const cv::Mat1b& grey) {
  cv::Mat1f smooth;
  cv::GaussianBlur(cv::Mat1f(grey), smooth, {5, 5}, 1.0, 1.0, cv::BORDER_REPLICATE);
  Gradients g;
  g.along_u = cv::Mat1f(grey.size(), 0.0F);
  g.along_v = cv::Mat1f(grey.size(), 0.0F);
  g.magnitude = cv::Mat1f(grey.size(), 0.0F);
  for (int v = 1; v + 1 < grey.rows; ++v) {
    const float* above = smooth[v - 1];
    const float* here = smooth[v];
    const float* below = smooth[v + 1];
    float* along_u = g.along_u[v];
    float* along_v = g.along_v[v];
    float* magnitude = g.magnitude[v];
    for (int u = 1; u + 1 < grey.cols; ++u) {
      const float du = 0.5F * (here[u + 1] - here[u - 1]);
      const float dv = 0.5F * (below[u] - above[u]);
      along_u[u] = du;
      along_v[u] = dv;
      magnitude[u] = std::sqrt(du * du + dv * dv);
    }
  }
  return g;
}

/// The upper median: floats that are not negative are ordered as their bits are, so the leading 16
/// bits say among which few it lies.
float median_of(const cv::Mat1f& magnitude) {
  // of a float's 32: sign, exponent and 7 bits of mantissa remain, less than 1 % wide
  constexpr int kFineBits = 16;
  const std::span<const float> values(magnitude.ptr<float>(), magnitude.total());
  std::vector<int> counts(std::size_t{1} << 15, 0);
  for (const float m : values) ++counts[std::bit_cast<std::uint32_t>(m) >> kFineBits];
  auto before = static_cast<std::ptrdiff_t>(magnitude.total() / 2);
  std::uint32_t bin = 0;
  while (before >= counts[bin]) before -= counts[bin++];
  std::vector<float> same;
  for (const float m : values) {
    if (std::bit_cast<std::uint32_t>(m) >> kFineBits == bin) same.push_back(m);
  }
  std::nth_element(same.begin(), same.begin() + before, same.end());
  return same[before];
}

float threshold_of(const cv::Mat1f& magnitude) {
  return std::clamp(kOverMedian * median_of(magnitude), kLeastGradient, kHighestFloor);
}

/// Direction of the strongest change around a pixel, as a unit vector.
cv::Vec2f tensor_normal(const Gradients& g, int v, int u) {
  float uu = 0.0F;
  float uv = 0.0F;
  float vv = 0.0F;
  for (int j = v - 1; j <= v + 1; ++j) {
    for (int i = u - 1; i <= u + 1; ++i) {
      const float a = g.along_u(j, i);
      const float b = g.along_v(j, i);
      uu += a * a;
      uv += a * b;
      vv += b * b;
    }
  }
  const float angle = 0.5F * std::atan2(2.0F * uv, uu - vv);
  return {std::cos(angle), std::sin(angle)};
}

float at(const cv::Mat1f& m, float v, float u) {
  const int v0 = static_cast<int>(v);
  const int u0 = static_cast<int>(u);
  const float b = v - static_cast<float>(v0);
  const float a = u - static_cast<float>(u0);
  return (1 - b) * ((1 - a) * m(v0, u0) + a * m(v0, u0 + 1)) +
         b * ((1 - a) * m(v0 + 1, u0) + a * m(v0 + 1, u0 + 1));
}

}  // namespace

std::vector<EdgePoint> find_edge_points(const cv::Mat1b& grey) {
  std::vector<EdgePoint> points;
  if (grey.rows < kSmallestSide_px || grey.cols < kSmallestSide_px) return points;
  const Gradients g = differentiate(grey);
  const float threshold = threshold_of(g.magnitude);
  for (int v = 2; v + 3 < grey.rows; ++v) {
    const float* magnitude = g.magnitude[v];
    for (int u = 2; u + 3 < grey.cols; ++u) {
      const float here = magnitude[u];
      if (here < threshold) continue;
      const float nu = g.along_u(v, u) / here;
      const float nv = g.along_v(v, u) / here;
      const auto fv = static_cast<float>(v);
      const auto fu = static_cast<float>(u);
      const float before = at(g.magnitude, fv - nv, fu - nu);
      const float after = at(g.magnitude, fv + nv, fu + nu);
      if (here < before || here <= after) continue;
      const float bend = before - 2.0F * here + after;
      const float shift = bend < 0.0F ? 0.5F * (before - after) / bend : 0.0F;
      const cv::Vec2f normal = tensor_normal(g, v, u);
      points.push_back({fu + shift * nu, fv + shift * nv, normal[0], normal[1],
                        std::min(1.0F, here / (kFullWeight * threshold))});
    }
  }
  return points;
}

}  // namespace striate::perception
