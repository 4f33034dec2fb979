#include "striate/platform/simulator/render/outdoors.hpp"

#include <numbers>

#include "striate/platform/simulator/render/noise.hpp"

namespace striate::simulator::render {
namespace {

struct Landscape {
  FractalNoise trees{{24, 4, 0.6F}, 7};
  FractalNoise clouds{{9, 4, 0.55F}, 8};
  FractalNoise leaves{{160, 3, 0.7F}, 9};
  FractalNoise grass{{90, 3, 0.7F}, 10};

  [[nodiscard]] V4 operator()(float azimuth, float rise) const {
    if (rise > 0.05F + 0.07F * trees(azimuth, 0.3F)) {
      const float up = std::min(1.0F, rise * 1.6F);
      const float cloud = std::max(0.0F, clouds(azimuth, rise * 0.7F));
      const V4 blue = lerp(bgr(1.0F, 0.95F, 0.88F), bgr(0.9F, 0.66F, 0.45F), up);
      return lerp(blue, splat(1.05F), std::min(1.0F, 1.6F * cloud));
    }
    if (rise > -0.015F) {
      const float leaf = 1.0F + 0.5F * leaves(azimuth, rise * 3.0F);
      return bgr(0.08F, 0.17F, 0.12F) * splat(leaf);
    }
    const float blade = 1.0F + 0.25F * grass(azimuth, 0.01F / rise);
    return bgr(0.12F, 0.32F, 0.24F) * splat(blade);
  }
};

}  // namespace

Outdoors::Outdoors() {
  const Landscape landscape;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      map_.push_back(landscape(static_cast<float>(x) / kWidth,
                               (static_cast<float>(y) + 0.5F) / kHalfHeight - 1.0F));
    }
  }
}

V4 Outdoors::operator()(Vec3 direction) const {
  const Vec3 d = unit(direction);
  const float around = std::atan2(d.y, d.x) / (2.0F * std::numbers::pi_v<float>)+1.0F;
  const float x = around * kWidth;
  const float y = std::clamp((d.z + 1.0F) * kHalfHeight - 0.5F, 0.0F, kHeight - 1.001F);
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const auto at = [this](int column, int row) {
    return map_[static_cast<std::size_t>(row * kWidth + column % kWidth)];
  };
  const float u = x - static_cast<float>(x0);
  return lerp(lerp(at(x0, y0), at(x0 + 1, y0), u), lerp(at(x0, y0 + 1), at(x0 + 1, y0 + 1), u),
              y - static_cast<float>(y0));
}

}  // namespace striate::simulator::render
