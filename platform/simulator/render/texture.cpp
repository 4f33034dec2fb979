#include "striate/platform/simulator/render/texture.hpp"

#include <bit>
#include <opencv2/imgproc.hpp>

namespace striate::simulator::render {
namespace {

int power_of_two(int side) {
  int power = 1;
  while (power * 3 / 2 < side && power < Texture::kMaxSide) power *= 2;
  return power;
}

std::uint32_t packed(const cv::Vec3f& linear) {
  std::uint32_t texel = 0;
  for (int c = 0; c < 3; ++c) {
    const float value = 255.0F * std::sqrt(std::clamp(linear[c], 0.0F, 1.0F)) + 0.5F;
    texel |= static_cast<std::uint32_t>(value) << (8 * c);
  }
  return texel;
}

}  // namespace

Texture::Texture(const cv::Mat3b& image)
    : width_(power_of_two(image.cols)), height_(power_of_two(image.rows)) {
  cv::Mat3b sized = image;
  if (image.cols != width_ || image.rows != height_) {
    cv::resize(image, sized, {width_, height_}, 0, 0, cv::INTER_AREA);
  }
  cv::Mat3f linear;
  sized.convertTo(linear, CV_32F, 1.0 / 255.0);
  linear = linear.mul(linear);
  while (true) {
    keep_level(linear);
    if (linear.cols == 1 && linear.rows == 1) break;
    cv::Mat3f half;
    cv::resize(linear, half, {std::max(1, linear.cols / 2), std::max(1, linear.rows / 2)}, 0, 0,
               cv::INTER_AREA);
    linear = half;
  }
  top_level_ = static_cast<float>(levels_.size() - 1);
  mean_ = bgr(linear(0, 0)[0], linear(0, 0)[1], linear(0, 0)[2]);
}

void Texture::keep_level(const cv::Mat3f& linear) {
  constexpr int kTile = 4;  // texels a side: a tile of 16 in 4 bytes is a line of the cache
  const int tiles_across = (linear.cols + kTile - 1) / kTile;
  const int tiles_down = (linear.rows + kTile - 1) / kTile;
  const int row_of_tiles = tiles_across * kTile * kTile;
  const std::size_t first = texels_.size();
  const Level level{static_cast<std::uint32_t>(first),
                    linear.cols - 1,
                    linear.rows - 1,
                    std::countr_zero(static_cast<unsigned>(row_of_tiles)),
                    256.0F * static_cast<float>(linear.cols),
                    256.0F * static_cast<float>(linear.rows)};
  levels_.push_back(level);
  texels_.resize(first + static_cast<std::size_t>(row_of_tiles * tiles_down));
  for (int y = 0; y < linear.rows; ++y) {
    for (int x = 0; x < linear.cols; ++x) {
      texels_[first + static_cast<std::size_t>(across(x) + down(y, level.shift))] =
          packed(linear(y, x));
    }
  }
}

}  // namespace striate::simulator::render
