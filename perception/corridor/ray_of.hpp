#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/base/index_within.hpp"

namespace striate::perception {

constexpr int kRays = 360;  ///< directions in which lines leave a point

/// The ray in which (du, dv) points, 0 .. kRays - 1: 0 begins at -u and they go round by one
/// degree. A short polynomial says it but near the border of two rays, where the arc tangent is
/// asked: the result is the arc tangent's everywhere (unit test), at a fifth of the time.
[[nodiscard]] inline int ray_of(float du, float dv) {
  const float u = std::abs(du);
  const float v = std::abs(dv);
  const float slope = std::min(u, v) / std::max(u, v);  // not a number at the origin: asked
  const float s = slope * slope;
  // Error below 0.0004 rad: 0.023 rays.
  float angle = ((-0.0464964749F * s + 0.15931422F) * s - 0.327622764F) * s * slope + slope;
  /// pi / 2: a quarter of a turn, rad
  constexpr auto kHalf = static_cast<float>(0.5 * std::numbers::pi);
  constexpr auto kWhole = static_cast<float>(std::numbers::pi);  ///< pi: half a turn, rad
  if (v > u) angle = kHalf - angle;
  if (du < 0.0F) angle = kWhole - angle;
  if (dv < 0.0F) angle = -angle;
  /// 180 / pi: rays of one degree
  constexpr float kRaysPer_rad = kRays * 0.5F * std::numbers::inv_pi_v<float>;
  const float ray = angle * kRaysPer_rad + 0.5F * kRays;
  constexpr float kBorder = 0.05F;  ///< rays: twice the polynomial's error, which is 0.023
  const auto whole = static_cast<float>(static_cast<int>(std::min(2.0F * kRays, ray)));
  if (ray > whole + kBorder && ray < whole + 1.0F - kBorder) return static_cast<int>(whole);
  const double turn = std::atan2(dv, du) / (2.0 * std::numbers::pi) + 0.5;
  return cut_within(turn * kRays, 0, kRays - 1);
}

}  // namespace striate::perception
