#pragma once

#include <opencv2/core/mat.hpp>

/// Cameras of 10, 12 or 14 bits hand out pixels of 16, whose upper bits stay empty: taken for
/// pixels of 16 bits they are black. One rule for files, messages and pictures of worlds.
namespace striate {

/// Bits that pixels of 16 bits can be told to have: the highest that is set anywhere, made up to 8,
/// 10, 12, 14 or 16, which are what sensors have. 8 for images of 8 bits and for empty ones. Eyes
/// of one pair are judged together, by the greater of the two, or one would be brighter than the
/// other.
[[nodiscard]] int bits_used(const cv::Mat& image);

/// The same picture with 8 bits a channel; `most` is the value that becomes 255, 1 to 65535.
[[nodiscard]] cv::Mat as_eight_bits(const cv::Mat& image, int most);

/// The greatest value of so many bits.
[[nodiscard]] constexpr int most_of_bits(int bits) {
  return (1 << bits) - 1;
}

}  // namespace striate
