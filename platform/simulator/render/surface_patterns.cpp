#include "striate/platform/simulator/render/surface_patterns.hpp"

#include <opencv2/core.hpp>

#include "striate/platform/simulator/render/noise.hpp"
#include "striate/platform/simulator/render/paint.hpp"

namespace striate::simulator::render {
namespace {

using Colour = cv::Vec3f;  // display values, blue green red

class Wood {
 public:
  Wood(const Colour& base, float strength) : base_(base), strength_(strength) {}

  /// Grain runs along x.
  [[nodiscard]] Colour operator()(float x, float y) const {
    const float bend = 0.03F * bend_noise_(x, y);
    const float ring = ring_noise_(x * 0.25F + 0.1F, y + bend);
    const float fibre = fibre_noise_(x * 0.125F, y + bend);
    return brighter(base_, strength_ * (16.0F * ring + 9.0F * fibre));
  }

 private:
  Colour base_;
  float strength_;
  FractalNoise bend_noise_{{3, 2, 0.5F}, 71};
  FractalNoise ring_noise_{{24, 3, 0.6F}, 72};
  FractalNoise fibre_noise_{{128, 2, 0.7F}, 73};
};

}  // namespace

cv::Mat3b plaster() {
  const FractalNoise trowel_noise({6, 3, 0.6F}, 11);
  const FractalNoise grain_noise({96, 3, 0.9F}, 12);
  const FractalNoise fleck_noise({40, 2, 0.5F}, 13);
  return painted(512, 512, [&](float x, float y) {
    const float trowel = trowel_noise(x, y * 0.5F);
    const float grain = grain_noise(x, y);
    const float fleck = fleck_noise(x, y) > 0.62F ? -7.0F : 0.0F;
    return brighter({204, 212, 216}, 3.5F * trowel + 4.0F * grain + fleck);
  });
}

cv::Mat3b blank_plaster() {
  const FractalNoise grain_noise({5, 2, 0.5F}, 21);
  return painted(256, 256, [&](float x, float y) {
    return brighter({208, 214, 217}, 0.9F * grain_noise(x, y));
  });
}

cv::Mat3b brick() {
  const FractalNoise wobble_noise({32, 2, 0.5F}, 31);
  const FractalNoise grain_noise({64, 3, 0.6F}, 32);
  return painted(512, 512, [&](float x, float y) {
    const float rows = y * 8.0F;
    const float row = std::floor(rows);
    const float columns = x * 4.0F + (static_cast<int>(row) % 2 == 0 ? 0.0F : 0.5F);
    const float column = std::floor(columns);
    const float wobble = 0.012F * wobble_noise(x, y);
    const float to_x =
        std::min(fraction(columns), 1.0F - fraction(columns)) * 0.25F + wobble * 0.3F;
    const float to_y = std::min(fraction(rows), 1.0F - fraction(rows)) * 0.075F + wobble * 0.3F;
    const float grain = grain_noise(x, y);
    if (std::min(to_x, to_y) < 0.006F) return brighter({128, 138, 145}, 14.0F * grain);
    const std::uint32_t id = mix(static_cast<std::uint32_t>(row) * 131U +
                                 static_cast<std::uint32_t>(static_cast<int>(column) % 4));
    const float shade = 36.0F * (uniform(id) - 0.5F);
    const float red = 18.0F * (uniform(mix(id)) - 0.5F);
    return brighter({58, 70, 128 + red}, shade + 16.0F * grain);
  });
}

cv::Mat3b linoleum() {
  const FractalNoise bend_noise({4, 3, 0.5F}, 41);
  const FractalNoise marble_noise({14, 4, 0.6F}, 42);
  const FractalNoise cloud_noise({3, 3, 0.6F}, 43);
  const FractalNoise fleck_noise({128, 1, 0.5F}, 44);
  return painted(512, 512, [&](float x, float y) {
    const float bend = 0.06F * bend_noise(x, y);
    const float marble = marble_noise(x + bend, y * 0.5F + bend);
    const float cloud = cloud_noise(x, y);
    const float fleck = fleck_noise(x, y);
    return brighter({138, 148, 152}, 17.0F * marble + 13.0F * cloud + 5.0F * fleck);
  });
}

cv::Mat3b tiles() {
  const FractalNoise grain_noise({48, 3, 0.6F}, 51);
  return painted(512, 512, [&](float x, float y) {
    const float to_x = std::min(fraction(x * 4.0F), 1.0F - fraction(x * 4.0F));
    const float to_y = std::min(fraction(y * 4.0F), 1.0F - fraction(y * 4.0F));
    const float grain = grain_noise(x, y);
    if (std::min(to_x, to_y) < 0.012F) return brighter({96, 100, 104}, 8.0F * grain);
    const auto id =
        mix(static_cast<std::uint32_t>(x * 4.0F) * 7U, static_cast<std::uint32_t>(y * 4.0F));
    return brighter({150, 162, 168}, 12.0F * (uniform(id) - 0.5F) + 8.0F * grain);
  });
}

cv::Mat3b carpet() {
  const FractalNoise loop_noise({128, 2, 0.8F}, 61);
  const FractalNoise wear_noise({4, 3, 0.5F}, 62);
  return painted(512, 512, [&](float x, float y) {
    const float loop = loop_noise(x, y);
    const float wear = wear_noise(x, y);
    return brighter({98, 86, 82}, 22.0F * loop + 7.0F * wear);
  });
}

cv::Mat3b wood() {
  return painted(512, 512, Wood({120, 158, 186}, 1.0F));
}

cv::Mat3b door_wood() {
  const Wood upright({84, 124, 164}, 0.9F);
  return painted(512, 512, [&](float x, float y) { return upright(y, x); });
}

cv::Mat3b dark_wood() {
  return painted(512, 512, Wood({48, 66, 92}, 0.9F));
}

cv::Mat3b styrofoam() {
  const FractalNoise bead_noise({48, 2, 0.6F}, 81);
  return painted(256, 256, [&](float x, float y) {
    const float bead = bead_noise(x, y);
    return brighter({226, 228, 228}, 7.0F * bead - 6.0F * std::max(0.0F, bead - 0.45F));
  });
}

cv::Mat3b concrete() {
  const FractalNoise stone_noise({64, 3, 0.75F}, 91);
  const FractalNoise stain_noise({4, 4, 0.5F}, 92);
  const FractalNoise pore_noise({96, 1, 0.5F}, 93);
  return painted(512, 512, [&](float x, float y) {
    const float stone = stone_noise(x, y);
    const float stain = stain_noise(x, y);
    const float pore = pore_noise(x, y) > 0.8F ? -34.0F : 0.0F;
    return brighter({150, 156, 158}, 15.0F * stone + 12.0F * stain + pore);
  });
}

cv::Mat3b ceiling() {
  const FractalNoise hole_noise({112, 1, 0.5F}, 101);
  const FractalNoise grain_noise({8, 3, 0.6F}, 102);
  return painted(512, 512, [&](float x, float y) {
    const float to_x = std::min(fraction(x * 2.0F), 1.0F - fraction(x * 2.0F));
    const float to_y = std::min(fraction(y * 2.0F), 1.0F - fraction(y * 2.0F));
    if (std::min(to_x, to_y) < 0.014F) return Colour{150, 154, 156};
    const float hole = hole_noise(x, y) > 0.7F ? -20.0F : 0.0F;
    return brighter({204, 208, 210}, 4.0F * grain_noise(x, y) + hole);
  });
}

cv::Mat3b wallpaper() {
  const FractalNoise grain_noise({64, 2, 0.6F}, 111);
  return painted(512, 512, [&](float x, float y) {
    const float u = fraction(x * 6.0F) - 0.5F;
    const float v = fraction(y * 6.0F + (static_cast<int>(x * 6.0F) % 2 == 0 ? 0.0F : 0.5F)) - 0.5F;
    const float ring = std::abs(std::sqrt(u * u + v * v) - 0.25F);
    const float line = ring < 0.04F || std::abs(u) + std::abs(v) < 0.08F ? -30.0F : 0.0F;
    return brighter({176, 196, 204}, line + 4.0F * grain_noise(x, y));
  });
}

cv::Mat3b panelling() {
  const Wood upright({92, 130, 160}, 0.8F);
  return painted(512, 512, [&](float x, float y) {
    const float joint =
        std::min(fraction(x * 8.0F), 1.0F - fraction(x * 8.0F)) < 0.03F ? -40.0F : 0.0F;
    return brighter(upright(y, x), joint);
  });
}

cv::Mat3b checked() {
  const FractalNoise grain_noise({48, 2, 0.7F}, 151);
  return painted(256, 256, [&](float x, float y) {
    const float a = fraction(x * 4.0F) < 0.5F ? 30.0F : 0.0F;
    const float b = fraction(y * 4.0F) < 0.5F ? 30.0F : 0.0F;
    return brighter({52 + a * 0.3F, 84 + b, 60 + a * 0.4F}, 7.0F * grain_noise(x, y));
  });
}

cv::Mat3b leaf() {
  const FractalNoise grain_noise({10, 3, 0.6F}, 161);
  return painted(128, 128, [&](float x, float y) {
    const float rib = std::abs(y - 0.5F) < 0.03F ? 40.0F : 0.0F;
    return brighter({40, 104, 58}, rib + 14.0F * grain_noise(x, y));
  });
}

cv::Mat3b earth() {
  const FractalNoise grain_noise({16, 3, 0.7F}, 171);
  return painted(128, 128, [&](float x, float y) {
    return brighter({44, 56, 70}, 24.0F * grain_noise(x, y));
  });
}

}  // namespace striate::simulator::render
