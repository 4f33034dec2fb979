#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

/// Images made by rule, the same on every machine.
namespace striate::reference {

/// A hash of two coordinates and a seed, 0..65535 (integer mixing after Jenkins).
inline int hash_noise(int x, int y, int seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1U ^
                    static_cast<std::uint32_t>(y) * 0x85EBCA77U ^
                    static_cast<std::uint32_t>(seed) * 0xC2B2AE3DU;
  h = (h ^ (h >> 15)) * 0x2C1B3C6DU;
  h = (h ^ (h >> 12)) * 0x297A2D39U;
  return static_cast<int>((h ^ (h >> 15)) & 0xFFFF);
}

/// Smooth random texture: grains of 1 to 8 px, grey 128 +- contrast.
inline int texture_at(int x, int y, int seed, int contrast = 100) {
  int sum = 0;
  for (const int grain : {1, 2, 4, 8}) {
    const int u = x >= 0 ? x / grain : (x - grain + 1) / grain;
    sum += hash_noise(u, y / grain, seed + grain) - 32768;
  }
  return std::clamp(128 + sum * contrast / (4 * 32768), 0, 255);
}

inline cv::Mat1b texture(cv::Size size, int seed, int shift_x = 0, int contrast = 100) {
  cv::Mat1b image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      image(y, x) = static_cast<std::uint8_t>(texture_at(x + shift_x, y, seed, contrast));
    }
  }
  return image;
}

/// Adds noise that is roughly normal (the sum of four uniform numbers).
inline cv::Mat1b with_noise(const cv::Mat1b& image, double sigma, int seed) {
  cv::Mat1b result(image.size());
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      double sum = 0.0;
      for (int k = 0; k < 4; ++k) sum += hash_noise(x, y, seed * 4 + k) / 65535.0 - 0.5;
      result(y, x) = cv::saturate_cast<std::uint8_t>(image(y, x) + sum * sigma * 1.732);
    }
  }
  return result;
}

}  // namespace striate::reference
