#pragma once

#include <opencv2/core.hpp>

namespace striate::perception {

/// Whether `image` is just four times as wide and as high as an image of `width`: 640 and 160.
[[nodiscard]] bool is_four_times(const cv::Mat& image, int width);

/// Sums over 4 x 4 pixels, which are the means in sixteenths of a grey level, exactly.
/// @param image 8 bits, one or three channels, both sides multiples of four.
[[nodiscard]] cv::Mat sums_of_fours(const cv::Mat& image);

/// Means over 4 x 4 pixels: bit for bit what cv::resize with INTER_AREA gives (a half goes to the
/// even neighbour); quicker, since OpenCV 4.6 has vectors for halving only.
/// @param image as for sums_of_fours.
[[nodiscard]] cv::Mat means_of_fours(const cv::Mat& image);

}  // namespace striate::perception
