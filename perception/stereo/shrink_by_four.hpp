#pragma once

#include <opencv2/core.hpp>

namespace striate {

/// Whether `picture` is just four times as wide and as high as a picture of `width`: 640 and 160.
[[nodiscard]] bool is_four_times(const cv::Mat& picture, int width);

/// Sums over 4 x 4 pixels, which are the means in sixteenths of a grey level, exactly.
/// @param picture 8 bits, one or three channels, both sides multiples of four.
[[nodiscard]] cv::Mat sums_of_fours(const cv::Mat& picture);

/// Means over 4 x 4 pixels: bit for bit what cv::resize with INTER_AREA gives (a half goes to the
/// even neighbour); quicker, since OpenCV 4.6 has vectors for halving only.
/// @param picture as for sums_of_fours.
[[nodiscard]] cv::Mat means_of_fours(const cv::Mat& picture);

}  // namespace striate
