#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

#include "striate/platform/datasets/images/image_header.hpp"

/// A picture as its file holds it.
namespace striate::datasets {

/// Turned and mirrored to what orientation 1 would be (EXIF 2.3, tag 0x0112).
[[nodiscard]] cv::Mat upright(const cv::Mat& image, int orientation);

/// A file as it was decoded: upright, but with the values that stand in it.
struct RawPicture {
  cv::Mat pixels;
  ImageHeader header;
};

[[nodiscard]] RawPicture read_raw(const std::filesystem::path& file, int flags);

/// The value that is white. Its decoder stretches the text kinds of PNM with up to 8 bits already.
[[nodiscard]] int white_of(const RawPicture& raw, int bits);

}  // namespace striate::datasets
