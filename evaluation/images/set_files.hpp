#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

/// What the layouts of public data sets have in common.
namespace striate::evaluation {

/// By the suffix, in either case: what OpenCV reads here.
[[nodiscard]] bool is_image(const std::filesystem::path& file);

/// 8-bit grey; the values of 16-bit files are divided by 256. Throws UserError naming the file
/// where it is no image.
[[nodiscard]] cv::Mat1b read_grey(const std::filesystem::path& file);

/// Nine numbers, row by row. Throws UserError naming the file where they are no homography.
[[nodiscard]] cv::Matx33d read_homography(const std::filesystem::path& file);

}  // namespace striate::evaluation
