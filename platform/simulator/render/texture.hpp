#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "platform/simulator/render/vec.hpp"

namespace striate::simulator::render {

/// A picture with its mip levels: each level is half as wide, so that one sample a pixel suffices
/// at any distance. Texels hold the square root of the albedo in 8 bits.
class Texture {
 public:
  Texture() = default;
  /// `picture`: display values (about the square root of linear light). Sides are brought to
  /// powers of two, at most `kMaxSide`.
  explicit Texture(const cv::Mat3b& picture);

  static constexpr int kMaxSide = 1024;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] V4 mean() const { return mean_; }  ///< linear albedo

  /// Linear albedo at (s, t) in repeats of the picture, s right, t down; `level` 0 is the finest.
  [[nodiscard]] V4 sample(float s, float t, float level) const;

 private:
  struct Level {
    std::uint32_t offset = 0;
    int width = 0;
    int height = 0;
  };
  [[nodiscard]] V4 bilinear(const Level& level, float s, float t) const;

  int width_ = 0;
  int height_ = 0;
  V4 mean_{};
  std::vector<Level> levels_;
  std::vector<std::uint32_t> texels_;
};

/// The four bytes of a texel as numbers. Spelt out by shuffles: compilers turn a plain conversion
/// of four bytes into scalar code, at three times the cost of a whole picture.
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

inline V4 Texture::bilinear(const Level& level, float s, float t) const {
  const float x = s * static_cast<float>(level.width) - 0.5F;
  const float y = t * static_cast<float>(level.height) - 0.5F;
  // Truncation of a shifted value is floor without a call to it.
  const int x0 = static_cast<int>(x + 65536.0F) - 65536;
  const int y0 = static_cast<int>(y + 65536.0F) - 65536;
  const float u = x - static_cast<float>(x0);
  const float v = y - static_cast<float>(y0);
  const int xa = x0 & (level.width - 1);
  const int xb = (x0 + 1) & (level.width - 1);
  const std::uint32_t* data = texels_.data() + level.offset;
  const std::uint32_t* top =
      data + static_cast<std::ptrdiff_t>(y0 & (level.height - 1)) * level.width;
  const std::uint32_t* low =
      data + static_cast<std::ptrdiff_t>((y0 + 1) & (level.height - 1)) * level.width;
  const auto load = [](const std::uint32_t* at) { return unpacked(*at); };
  const V4 a = lerp(load(top + xa), load(top + xb), u);
  const V4 b = lerp(load(low + xa), load(low + xb), u);
  return lerp(a, b, v);
}

inline V4 Texture::sample(float s, float t, float level) const {
  // Keeps the coordinates small, so that the shift in `bilinear` holds.
  s -= static_cast<float>(static_cast<int>(s));
  t -= static_cast<float>(static_cast<int>(t));
  const float top = static_cast<float>(levels_.size() - 1);
  const float clamped = std::min(std::max(level, 0.0F), top);
  const auto fine = static_cast<std::size_t>(clamped);
  const float between = clamped - static_cast<float>(fine);
  V4 value = bilinear(levels_[fine], s, t);
  if (between > 0.02F) {
    value = lerp(value, bilinear(levels_[std::min(fine + 1, levels_.size() - 1)], s, t), between);
  }
  return value * value * splat(1.0F / (255.0F * 255.0F));
}

}  // namespace striate::simulator::render
