#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/platform/simulator/render/vec.hpp"

namespace striate::simulator::render {

/// A image with its mip levels: each level is half as wide, so that one sample a pixel suffices
/// at any distance. Texels hold the square root of the albedo in 8 bits.
class Texture {
 public:
  Texture() = default;
  /// `image`: display values (about the square root of linear light). Sides are brought to
  /// powers of two, at most `kMaxSide`.
  explicit Texture(const cv::Mat3b& image);

  /// Texels: 2 mm on a poster of 2 m, a pixel of width 320 seen 0.8 m away
  static constexpr int kMaxSide = 1024;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] V4 mean() const { return mean_; }  ///< linear albedo

  /// One mip level. Its texels lie in tiles of 4x4, a cache line each: neighbours up and down are
  /// near as well.
  struct Level {
    std::uint32_t offset = 0;
    std::int32_t mask_u = 0;  ///< width - 1
    std::int32_t mask_v = 0;
    int shift = 0;         ///< log2 of the texels in a row of tiles
    float scale_u = 0.0F;  ///< 256 times the width
    float scale_v = 0.0F;
  };
  /// The level nearest to `level`; 0 is the finest. Blending two levels costs a tenth of the
  /// image's time and shows no difference under the sensor's noise.
  [[nodiscard]] const Level& level(float level) const {
    return levels_[static_cast<std::size_t>(std::min(std::max(level + 0.5F, 0.0F), top_level_))];
  }
  /// Linear albedo at (s, t) in repeats of the image, s right, t down; bilinear.
  [[nodiscard]] V4 sample(const Level& level, float s, float t) const;
  /// For those who know where texels lie; see Level.
  [[nodiscard]] const std::uint32_t* texels() const { return texels_.data(); }

 private:
  /// Where a texel lies: across(x) + down(y).
  static int across(int x) { return ((x >> 2) << 4) | (x & 3); }
  static int down(int y, int shift) { return ((y >> 2) << shift) | ((y & 3) << 2); }
  void keep_level(const cv::Mat3f& linear);

  int width_ = 0;
  int height_ = 0;
  V4 mean_{};
  float top_level_ = 0.0F;
  std::vector<Level> levels_;
  std::vector<std::uint32_t> texels_;
};

/// The four bytes of a texel as numbers. Spelt out by shuffles: compilers turn a plain conversion
/// of four bytes into scalar code, at three times the cost of a whole image.
[[nodiscard]] inline V4 unpacked(std::uint32_t texel) {
  using Bytes = std::uint8_t __attribute__((vector_size(16)));
  using Shorts = std::uint16_t __attribute__((vector_size(16)));
  const I4 whole{static_cast<std::int32_t>(texel), 0, 0, 0};
  const Bytes zero{};
  const Bytes shorts = __builtin_shufflevector((Bytes)whole, zero, 0, 16, 1, 17, 2, 18, 3, 19, 4,
                                               20, 5, 21, 6, 22, 7, 23);
  const Shorts none{};
  const Shorts words = __builtin_shufflevector((Shorts)shorts, none, 0, 8, 1, 9, 2, 10, 3, 11);
  return __builtin_convertvector((I4)words, V4);
}

inline V4 Texture::sample(const Level& level, float s, float t) const {
  // Fixed point with eight bits of fraction, of the fractional part: it keeps numbers small.
  s -= static_cast<float>(static_cast<int>(s));
  t -= static_cast<float>(static_cast<int>(t));
  const int x = static_cast<int>((s + 1.0F) * level.scale_u) - 128;
  const int y = static_cast<int>((t + 1.0F) * level.scale_v) - 128;
  const float u = static_cast<float>(x & 255) * (1.0F / 256.0F);
  const float v = static_cast<float>(y & 255) * (1.0F / 256.0F);
  const int xa = (x >> 8) & level.mask_u;
  const int xb = ((x >> 8) + 1) & level.mask_u;
  const int ya = (y >> 8) & level.mask_v;
  const int yb = ((y >> 8) + 1) & level.mask_v;
  const std::uint32_t* data = texels_.data() + level.offset;
  const std::uint32_t* top = data + down(ya, level.shift);
  const std::uint32_t* low = data + down(yb, level.shift);
  const V4 a = lerp(unpacked(top[across(xa)]), unpacked(top[across(xb)]), u);
  const V4 b = lerp(unpacked(low[across(xa)]), unpacked(low[across(xb)]), u);
  const V4 value = lerp(a, b, v);
  return value * value * splat(1.0F / (255.0F * 255.0F));
}

}  // namespace striate::simulator::render
