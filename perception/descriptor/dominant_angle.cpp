#include "perception/descriptor/dominant_angle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <opencv2/core.hpp>

namespace striate {
namespace {

constexpr int kBefore_px = 6;
constexpr int kSide_px = 14;
constexpr int kColumns = 16;  ///< summed in each row; the last two are left out
constexpr double kSigma_px = 2.0;
constexpr std::size_t kBins = 36;
constexpr int kSmoothings = 6;
constexpr float kLeastWeight = 0.02F;  ///< beyond 2.8 sigma nothing is counted
constexpr float kSecondPeak = 0.8F;    ///< of the highest

using Histogram = std::array<float, kBins>;

/// cos and sin of each orientation.
struct Directions {
  std::array<float, kOrientations> u{}, v{};
  Directions() {
    for (std::size_t i = 0; i < kOrientations; ++i) {
      const double theta = static_cast<double>(i) * std::numbers::pi / kOrientations;
      u[i] = static_cast<float>(std::cos(theta));
      v[i] = static_cast<float>(std::sin(theta));
    }
  }
};

std::array<float, kSide_px> gaussian_row(double middle) {
  std::array<float, kSide_px> row{};
  for (std::size_t x = 0; x < row.size(); ++x) {
    const double d = static_cast<double>(x) - kBefore_px - middle;
    row[x] = static_cast<float>(std::exp(-d * d / (2.0 * kSigma_px * kSigma_px)));
  }
  return row;
}

void add(float u, float v, float weight, Histogram& histogram) {
  const float length = std::sqrt(u * u + v * v) * weight;
  const float bin = cv::fastAtan2(v, u) * (static_cast<float>(kBins) / 360.0F);
  const auto low = static_cast<std::size_t>(bin);
  const float share = bin - static_cast<float>(low);
  histogram[low % kBins] += length * (1.0F - share);
  histogram[(low + 1) % kBins] += length * share;
}

Histogram histogram_of(const pooling_kernels::OddWindow& at, double u, double v) {
  static const Directions directions;
  const auto across = gaussian_row(u), down = gaussian_row(v);
  Histogram histogram{};
  for (std::size_t y = 0; y < kSide_px; ++y) {
    std::array<float, kColumns> sum_u{}, sum_v{};
    for (std::size_t i = 0; i < kOrientations; ++i) {
      const std::int16_t* odd =
          at.odd[i] + (static_cast<std::ptrdiff_t>(y) - kBefore_px) * at.stride - kBefore_px;
      for (std::size_t x = 0; x < kColumns; ++x) {
        sum_u[x] += static_cast<float>(odd[x]) * directions.u[i];
        sum_v[x] += static_cast<float>(odd[x]) * directions.v[i];
      }
    }
    for (std::size_t x = 0; x < kSide_px; ++x) {
      const float weight = across[x] * down[y];
      if (weight >= kLeastWeight) add(sum_u[x], sum_v[x], weight, histogram);
    }
  }
  return histogram;
}

void smooth(Histogram& histogram) {
  for (int round = 0; round < kSmoothings; ++round) {
    const Histogram h = histogram;
    for (std::size_t b = 0; b < kBins; ++b) {
      histogram[b] = 0.25F * (h[(b + kBins - 1) % kBins] + 2.0F * h[b] + h[(b + 1) % kBins]);
    }
  }
}

}  // namespace

DominantAngles dominant_angles(const pooling_kernels::OddWindow& at, double u, double v) {
  Histogram h = histogram_of(at, u, v);
  smooth(h);
  struct Peak {
    float height = 0.0F;
    double bin = 0.0;
  };
  std::array<Peak, 2> best;
  for (std::size_t b = 0; b < kBins; ++b) {
    const float before = h[(b + kBins - 1) % kBins], after = h[(b + 1) % kBins];
    if (h[b] <= before || h[b] < after) continue;
    // The peak of the parabola through the three.
    const double curvature = before - 2.0 * h[b] + after;
    const Peak peak{h[b], static_cast<double>(b) + 0.5 * (before - after) / curvature};
    if (peak.height > best[0].height) {
      best[1] = best[0];
      best[0] = peak;
    } else if (peak.height > best[1].height) {
      best[1] = peak;
    }
  }
  DominantAngles result;
  constexpr double kBin_rad = 2.0 * std::numbers::pi / kBins;
  for (std::size_t k = 0; k < best.size(); ++k) result.angle_rad[k] = best[k].bin * kBin_rad;
  const bool second = best[1].height > 0.0F && best[1].height >= kSecondPeak * best[0].height;
  result.count = second ? 2 : 1;
  return result;
}

}  // namespace striate
