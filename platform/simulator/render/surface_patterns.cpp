#include "striate/platform/simulator/render/surface_patterns.hpp"

#include <opencv2/core.hpp>

#include "striate/platform/simulator/render/noise.hpp"
#include "striate/platform/simulator/render/paint.hpp"

namespace striate::simulator::render {
namespace {

using Colour = cv::Vec3f;  // display values, blue green red

/// Grain runs along x.
Colour wooden(float x, float y, const Colour& base, float strength) {
  const float bend = 0.03F * fractal_noise(x, y, {3, 2, 0.5F}, 71);
  const float ring = fractal_noise(x * 0.25F + 0.1F, y + bend, {24, 3, 0.6F}, 72);
  const float fibre = fractal_noise(x * 0.125F, y + bend, {128, 2, 0.7F}, 73);
  return brighter(base, strength * (16.0F * ring + 9.0F * fibre));
}

}  // namespace

cv::Mat3b plaster() {
  return painted(512, 512, [](float x, float y) {
    const float trowel = fractal_noise(x, y * 0.5F, {6, 3, 0.6F}, 11);
    const float grain = fractal_noise(x, y, {96, 3, 0.9F}, 12);
    const float fleck = fractal_noise(x, y, {40, 2, 0.5F}, 13) > 0.62F ? -7.0F : 0.0F;
    return brighter({204, 212, 216}, 3.5F * trowel + 4.0F * grain + fleck);
  });
}

cv::Mat3b blank_plaster() {
  return painted(256, 256, [](float x, float y) {
    return brighter({208, 214, 217}, 0.9F * fractal_noise(x, y, {5, 2, 0.5F}, 21));
  });
}

cv::Mat3b brick() {
  return painted(512, 512, [](float x, float y) {
    const float rows = y * 8.0F;
    const float row = std::floor(rows);
    const float columns = x * 4.0F + (static_cast<int>(row) % 2 == 0 ? 0.0F : 0.5F);
    const float column = std::floor(columns);
    const float wobble = 0.012F * fractal_noise(x, y, {32, 2, 0.5F}, 31);
    const float to_x =
        std::min(fraction(columns), 1.0F - fraction(columns)) * 0.25F + wobble * 0.3F;
    const float to_y = std::min(fraction(rows), 1.0F - fraction(rows)) * 0.075F + wobble * 0.3F;
    const float grain = fractal_noise(x, y, {64, 3, 0.6F}, 32);
    if (std::min(to_x, to_y) < 0.006F) return brighter({128, 138, 145}, 14.0F * grain);
    const std::uint32_t id = mix(static_cast<std::uint32_t>(row) * 131U +
                                 static_cast<std::uint32_t>(static_cast<int>(column) % 4));
    const float shade = 36.0F * (uniform(id) - 0.5F);
    const float red = 18.0F * (uniform(mix(id)) - 0.5F);
    return brighter({58, 70, 128 + red}, shade + 16.0F * grain);
  });
}

cv::Mat3b linoleum() {
  return painted(512, 512, [](float x, float y) {
    const float bend = 0.06F * fractal_noise(x, y, {4, 3, 0.5F}, 41);
    const float marble = fractal_noise(x + bend, y * 0.5F + bend, {14, 4, 0.6F}, 42);
    const float cloud = fractal_noise(x, y, {3, 3, 0.6F}, 43);
    const float fleck = fractal_noise(x, y, {128, 1, 0.5F}, 44);
    return brighter({138, 148, 152}, 17.0F * marble + 13.0F * cloud + 5.0F * fleck);
  });
}

cv::Mat3b tiles() {
  return painted(512, 512, [](float x, float y) {
    const float to_x = std::min(fraction(x * 4.0F), 1.0F - fraction(x * 4.0F));
    const float to_y = std::min(fraction(y * 4.0F), 1.0F - fraction(y * 4.0F));
    const float grain = fractal_noise(x, y, {48, 3, 0.6F}, 51);
    if (std::min(to_x, to_y) < 0.012F) return brighter({96, 100, 104}, 8.0F * grain);
    const auto id =
        mix(static_cast<std::uint32_t>(x * 4.0F) * 7U, static_cast<std::uint32_t>(y * 4.0F));
    return brighter({150, 162, 168}, 12.0F * (uniform(id) - 0.5F) + 8.0F * grain);
  });
}

cv::Mat3b carpet() {
  return painted(512, 512, [](float x, float y) {
    const float loop = fractal_noise(x, y, {128, 2, 0.8F}, 61);
    const float wear = fractal_noise(x, y, {4, 3, 0.5F}, 62);
    return brighter({98, 86, 82}, 22.0F * loop + 7.0F * wear);
  });
}

cv::Mat3b wood() {
  return painted(512, 512, [](float x, float y) { return wooden(x, y, {120, 158, 186}, 1.0F); });
}

cv::Mat3b door_wood() {
  return painted(512, 512, [](float x, float y) { return wooden(y, x, {84, 124, 164}, 0.9F); });
}

cv::Mat3b dark_wood() {
  return painted(512, 512, [](float x, float y) { return wooden(x, y, {48, 66, 92}, 0.9F); });
}

cv::Mat3b styrofoam() {
  return painted(256, 256, [](float x, float y) {
    const float bead = fractal_noise(x, y, {48, 2, 0.6F}, 81);
    return brighter({226, 228, 228}, 7.0F * bead - 6.0F * std::max(0.0F, bead - 0.45F));
  });
}

cv::Mat3b concrete() {
  return painted(512, 512, [](float x, float y) {
    const float stone = fractal_noise(x, y, {64, 3, 0.75F}, 91);
    const float stain = fractal_noise(x, y, {4, 4, 0.5F}, 92);
    const float pore = fractal_noise(x, y, {96, 1, 0.5F}, 93) > 0.8F ? -34.0F : 0.0F;
    return brighter({150, 156, 158}, 15.0F * stone + 12.0F * stain + pore);
  });
}

cv::Mat3b ceiling() {
  return painted(512, 512, [](float x, float y) {
    const float to_x = std::min(fraction(x * 2.0F), 1.0F - fraction(x * 2.0F));
    const float to_y = std::min(fraction(y * 2.0F), 1.0F - fraction(y * 2.0F));
    if (std::min(to_x, to_y) < 0.014F) return Colour{150, 154, 156};
    const float hole = fractal_noise(x, y, {112, 1, 0.5F}, 101) > 0.7F ? -20.0F : 0.0F;
    return brighter({204, 208, 210}, 4.0F * fractal_noise(x, y, {8, 3, 0.6F}, 102) + hole);
  });
}

cv::Mat3b wallpaper() {
  return painted(512, 512, [](float x, float y) {
    const float u = fraction(x * 6.0F) - 0.5F;
    const float v = fraction(y * 6.0F + (static_cast<int>(x * 6.0F) % 2 == 0 ? 0.0F : 0.5F)) - 0.5F;
    const float ring = std::abs(std::sqrt(u * u + v * v) - 0.25F);
    const float line = ring < 0.04F || std::abs(u) + std::abs(v) < 0.08F ? -30.0F : 0.0F;
    return brighter({176, 196, 204}, line + 4.0F * fractal_noise(x, y, {64, 2, 0.6F}, 111));
  });
}

cv::Mat3b panelling() {
  return painted(512, 512, [](float x, float y) {
    const float joint =
        std::min(fraction(x * 8.0F), 1.0F - fraction(x * 8.0F)) < 0.03F ? -40.0F : 0.0F;
    return brighter(wooden(y, x, {92, 130, 160}, 0.8F), joint);
  });
}

cv::Mat3b checked() {
  return painted(256, 256, [](float x, float y) {
    const float a = fraction(x * 4.0F) < 0.5F ? 30.0F : 0.0F;
    const float b = fraction(y * 4.0F) < 0.5F ? 30.0F : 0.0F;
    return brighter({52 + a * 0.3F, 84 + b, 60 + a * 0.4F},
                    7.0F * fractal_noise(x, y, {48, 2, 0.7F}, 151));
  });
}

cv::Mat3b leaf() {
  return painted(128, 128, [](float x, float y) {
    const float rib = std::abs(y - 0.5F) < 0.03F ? 40.0F : 0.0F;
    return brighter({40, 104, 58}, rib + 14.0F * fractal_noise(x, y, {10, 3, 0.6F}, 161));
  });
}

cv::Mat3b earth() {
  return painted(128, 128, [](float x, float y) {
    return brighter({44, 56, 70}, 24.0F * fractal_noise(x, y, {16, 3, 0.7F}, 171));
  });
}

}  // namespace striate::simulator::render
