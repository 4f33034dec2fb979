#pragma once

#include <cstdint>

#include "striate/platform/simulator/render/noise.hpp"
#include "striate/platform/simulator/render/vec.hpp"

namespace striate::simulator::render {

/// One row of a sensor as it is read out.
struct ReadOutRow {
  std::uint32_t noise_key = 0;  ///< of this row in this image
  /// Lane of the colour that the filter lets through at even and odd columns, and how much.
  std::array<int, 2> colour{};
  std::array<float, 2> filter{};
  float electrons = 0.0F;  ///< per unit of light
  float full_well_e = 0.0F;
  float read_variance_e2 = 0.0F;
  float noise = 1.0F;  ///< 0: none
  float gain = 1.0F;
};

/// Light to grey levels of full scale: `read_out_pixel` for each pixel, bit for bit, on the best
/// instruction set of the machine.
void read_out_row(const ReadOutRow& row, const GaussTable& gauss, const V4* light,
                  const float* sensitivity, int width, float* out);

/// A full well holds no more, however bright the light; shot noise and read noise.
[[nodiscard]] inline float read_out_pixel(const ReadOutRow& row, const GaussTable& gauss,
                                          const V4* light, const float* sensitivity, int x) {
  const auto odd = static_cast<std::size_t>(x % 2);
  const float filter = row.filter[odd];
  const float mean = std::min(row.full_well_e,
                              light[x][row.colour[odd]] * row.electrons * sensitivity[x] * filter);
  const float sigma = std::sqrt(mean + row.read_variance_e2);
  const float counted =
      mean +
      row.noise * sigma * gauss(mix(row.noise_key + static_cast<std::uint32_t>(x) * 0x9E3779B9U));
  return std::min(1.0F, counted * row.gain / (row.full_well_e * filter));
}

}  // namespace striate::simulator::render
