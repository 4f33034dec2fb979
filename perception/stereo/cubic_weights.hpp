#pragma once

#include <array>
#include <cmath>

namespace striate::perception {

inline constexpr int kCubicParts =
    16;  ///< of a pixel: 0.06 px, a third of what a disparity errs by
inline constexpr int kCubicOne = 4096;  ///< scale of the weights: times the largest grey below 2^31

/// Largest fine grey, 255 in sixteenths (to_fine_working_size): beside edges a cubic goes beyond it
inline constexpr int kWhitestFine = 4080;

/// Weights of four neighbours for a place `part` sixteenths beyond the second (Catmull and Rom
/// 1974).
[[nodiscard]] inline std::array<int, 4> cubic_weights(int part) {
  const double t = static_cast<double>(part) / kCubicParts;
  const double t2 = t * t;
  const double t3 = t2 * t;
  std::array<int, 4> weights{};
  weights[0] = static_cast<int>(std::lround(kCubicOne * 0.5 * (-t3 + 2.0 * t2 - t)));
  weights[2] = static_cast<int>(std::lround(kCubicOne * 0.5 * (-3.0 * t3 + 4.0 * t2 + t)));
  weights[3] = static_cast<int>(std::lround(kCubicOne * 0.5 * (t3 - t2)));
  weights[1] = kCubicOne - weights[0] - weights[2] - weights[3];
  return weights;
}

}  // namespace striate::perception
