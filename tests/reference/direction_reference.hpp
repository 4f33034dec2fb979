#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/perception/descriptor/direction_kernels.hpp"

/// What perception/descriptor/direction_kernels.hpp promises, in plain loops.
namespace striate::reference {

/// atan2(v, u) in degrees, 0..360.
inline float angle_deg(float v, float u) {
  constexpr auto kDegrees = static_cast<float>(180.0 / std::numbers::pi);
  const float along = std::abs(u), across = std::abs(v);
  const float ratio = std::min(along, across) / (std::max(along, across) + 2.2204460492503131e-16F);
  const float square = ratio * ratio;
  float angle = -0.04432655554792128F * kDegrees;
  angle = angle * square + 0.1555786518463281F * kDegrees;
  angle = angle * square + -0.3258083974640975F * kDegrees;
  angle = angle * square + 0.9997878412794807F * kDegrees;
  angle *= ratio;
  if (along < across) angle = 90.0F - angle;
  if (u < 0.0F) angle = 180.0F - angle;
  return v < 0.0F ? 360.0F - angle : angle;
}

inline void share_directions(const perception::pooling_kernels::OddWindow& at,
                             const perception::direction_kernels::Weights& weights,
                             perception::direction_kernels::Shares& out) {
  using namespace perception::direction_kernels;
  for (std::size_t k = 0; k < out.bin.size(); ++k) {
    const std::size_t x = k % kColumns, y = k / kColumns;
    float u = 0.0F, v = 0.0F;
    for (std::size_t i = 0; i < perception::kOrientations; ++i) {
      const double theta = static_cast<double>(i) * std::numbers::pi / perception::kOrientations;
      const auto row = static_cast<std::ptrdiff_t>(y) - kBefore_px;
      const auto odd =
          static_cast<float>(at.odd[i][row * at.stride + static_cast<int>(x) - kBefore_px]);
      u += odd * static_cast<float>(std::cos(theta));
      v += odd * static_cast<float>(std::sin(theta));
    }
    const float length = std::sqrt(u * u + v * v) * (weights.across[x] * weights.down[y]);
    const float bin = angle_deg(v, u) * (static_cast<float>(kBins) / 360.0F);
    const int low = static_cast<int>(bin);
    const float part = bin - static_cast<float>(low);
    out.bin[k] = low % kBins;
    out.next_bin[k] = (low + 1) % kBins;
    out.share[k] = length * (1.0F - part);
    out.next_share[k] = length * part;
  }
}

}  // namespace striate::reference
