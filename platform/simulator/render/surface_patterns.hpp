#pragma once

#include <opencv2/core.hpp>

#include "striate/platform/simulator/render/noise.hpp"
#include "striate/platform/simulator/render/paint.hpp"

/// Patterns of surfaces: what each looks like at a place.
namespace striate::simulator::render {

using Colour = cv::Vec3f;  // display values, blue green red

inline Colour brighter(const Colour& colour, float by) {
  return {colour[0] + by, colour[1] + by, colour[2] + by};
}

inline float fraction(float x) {
  return x - std::floor(x);
}

/// Calls `colour(x, y)` with x right and y down in [0, 1) for each texel.
template <class Function>
cv::Mat3b painted(int width, int height, Function colour) {
  cv::Mat3b picture(height, width);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const Colour c = colour((static_cast<float>(u) + 0.5F) / static_cast<float>(width),
                              (static_cast<float>(v) + 0.5F) / static_cast<float>(height));
      for (int k = 0; k < 3; ++k) picture(v, u)[k] = cv::saturate_cast<std::uint8_t>(c[k]);
    }
  }
  return picture;
}

[[nodiscard]] cv::Mat3b plaster();

[[nodiscard]] cv::Mat3b blank_plaster();

[[nodiscard]] cv::Mat3b brick();

[[nodiscard]] cv::Mat3b linoleum();

[[nodiscard]] cv::Mat3b tiles();

[[nodiscard]] cv::Mat3b carpet();

[[nodiscard]] cv::Mat3b wood();

[[nodiscard]] cv::Mat3b door_wood();

[[nodiscard]] cv::Mat3b dark_wood();

[[nodiscard]] cv::Mat3b styrofoam();

[[nodiscard]] cv::Mat3b concrete();

[[nodiscard]] cv::Mat3b ceiling();

[[nodiscard]] cv::Mat3b wallpaper();

[[nodiscard]] cv::Mat3b panelling();

/// A plain colour with a little grain, so that nothing is perfectly flat.
template <int kBlue, int kGreen, int kRed, int kGrain>
cv::Mat3b plain() {
  const FractalNoise grain({24, 3, 0.7F}, 121);
  return painted(128, 128, [&](float x, float y) {
    return brighter({kBlue, kGreen, kRed}, kGrain * grain(x, y));
  });
}

template <int kBlue, int kGreen, int kRed>
cv::Mat3b woven() {
  const FractalNoise crease_noise({4, 3, 0.6F}, 131);
  const FractalNoise grain_noise({48, 2, 0.7F}, 132);
  return painted(128, 128, [&](float x, float y) {
    const float weave = std::sin(x * 201.0F) * std::sin(y * 201.0F);
    const float crease = crease_noise(x, y);
    return brighter({kBlue, kGreen, kRed},
                    7.0F * weave + 11.0F * crease + 9.0F * grain_noise(x, y));
  });
}

template <int kBlue, int kGreen, int kRed>
cv::Mat3b striped() {
  const FractalNoise grain_noise({48, 2, 0.7F}, 141);
  return painted(128, 256, [&](float x, float y) {
    const float grain = 7.0F * grain_noise(x, y);
    const bool first = fraction(y * 2.0F) < 0.5F;
    return brighter(first ? Colour{kBlue, kGreen, kRed} : Colour{205, 210, 214}, grain);
  });
}

[[nodiscard]] cv::Mat3b checked();

[[nodiscard]] cv::Mat3b leaf();

[[nodiscard]] cv::Mat3b earth();

}  // namespace striate::simulator::render
