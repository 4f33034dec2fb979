#include "striate/perception/descriptor/dominant_angle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/perception/descriptor/direction_kernels.hpp"

namespace striate::perception {
namespace {

using direction_kernels::kBefore_px;
using direction_kernels::kColumns;
using direction_kernels::kSide_px;

/// Gaussian of one diameter (2 px); the best of 2, 3, 4 px (README, own angles)
constexpr double kSigma_px = 2.0;
constexpr std::size_t kBins = direction_kernels::kBins;  ///< of 10 degrees, as the kernels count
/// By (1 2 1) / 4: a Gaussian of sqrt(6 / 2) = 1.7 bins, 17 degrees (ours)
constexpr int kSmoothings = 6;
/// Of the middle's: beyond 2.8 sigma nothing is counted, 0.02 = exp(-2.8^2 / 2)
constexpr float kLeastWeight = 0.02F;
/// Of the highest; 1.33 angles a frame, of which one is right in 95.8 % (README, own angles)
constexpr float kSecondPeak = 0.8F;

/// Bin b is at b + 1; before the first stands the last and behind the last the first.
using Histogram = std::array<float, kBins + 2>;

template <std::size_t kSize>
void gaussian_row(double middle, std::array<float, kSize>& row) {
  for (std::size_t x = 0; x < kSide_px; ++x) {
    const double d = static_cast<double>(x) - kBefore_px - middle;
    row[x] = static_cast<float>(std::exp(-d * d / (2.0 * kSigma_px * kSigma_px)));
  }
}

void close_circle(Histogram& histogram) {
  histogram[0] = histogram[kBins];
  histogram[kBins + 1] = histogram[1];
}

void histogram_of(const pooling_kernels::OddWindow& at, double u, double v, Histogram& histogram) {
  direction_kernels::Weights weights;
  gaussian_row(u, weights.across);
  gaussian_row(v, weights.down);
  direction_kernels::Shares shares;
  direction_kernels::share_directions(at, weights, shares);
  histogram.fill(0.0F);
  for (std::size_t y = 0; y < kSide_px; ++y) {
    // The Gaussian has one peak: what counts lies together.
    std::size_t from = 0, to = kSide_px;
    while (from < to && weights.across[from] * weights.down[y] < kLeastWeight) ++from;
    while (to > from && weights.across[to - 1] * weights.down[y] < kLeastWeight) --to;
    for (std::size_t k = y * kColumns + from; k < y * kColumns + to; ++k) {
      histogram[static_cast<std::size_t>(shares.bin[k]) + 1] += shares.share[k];
      histogram[static_cast<std::size_t>(shares.next_bin[k]) + 1] += shares.next_share[k];
    }
  }
  close_circle(histogram);
}

void smooth(Histogram& histogram) {
  for (int round = 0; round < kSmoothings; ++round) {
    float before = histogram[0];
    for (std::size_t b = 1; b <= kBins; ++b) {
      const float here = histogram[b];
      histogram[b] = 0.25F * (before + 2.0F * here + histogram[b + 1]);
      before = here;
    }
    close_circle(histogram);
  }
}

}  // namespace

DominantAngles dominant_angles(const pooling_kernels::OddWindow& at, double u, double v) {
  Histogram h;
  histogram_of(at, u, v, h);
  smooth(h);
  struct Peak {
    float height = 0.0F;
    double bin = 0.0;
  };
  std::array<Peak, 2> best;
  for (std::size_t b = 1; b <= kBins; ++b) {
    const float before = h[b - 1], after = h[b + 1];
    if (h[b] <= before || h[b] < after) continue;
    // The peak of the parabola through the three.
    const double curvature = before - 2.0 * h[b] + after;
    const Peak peak{h[b], static_cast<double>(b - 1) + 0.5 * (before - after) / curvature};
    if (peak.height > best[0].height) {
      best[1] = best[0];
      best[0] = peak;
    } else if (peak.height > best[1].height) {
      best[1] = peak;
    }
  }
  DominantAngles result;
  constexpr double kBin_rad = 2.0 * std::numbers::pi / kBins;  // 10 degrees in radians
  for (std::size_t k = 0; k < best.size(); ++k) result.angle_rad[k] = best[k].bin * kBin_rad;
  const bool second = best[1].height > 0.0F && best[1].height >= kSecondPeak * best[0].height;
  result.count = second ? 2 : 1;
  return result;
}

}  // namespace striate::perception
