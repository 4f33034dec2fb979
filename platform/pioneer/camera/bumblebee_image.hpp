#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>

namespace striate::pioneer {

/// Takes the Bumblebee-2's image apart. In each 16-bit pixel of its RAW16 image one byte is of
/// the right camera, the next of the left one (little-endian transfer), each in Bayer colours
/// G R over B G.
/// @param raw 2 * width * height bytes. @returns false where they are not as many.
[[nodiscard]] bool split_bumblebee(std::span<const std::uint8_t> raw, cv::Size size_px,
                                   cv::Mat3b& left, cv::Mat3b& right);

}  // namespace striate::pioneer
