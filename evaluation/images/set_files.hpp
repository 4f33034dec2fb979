#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

/// What the layouts of public data sets have in common.
namespace striate::evaluation {

/// Numbers that stand in a picture, a truth or a mask: as they are, those of 16 bits divided by
/// 256. Pictures of things are read by datasets::read_any_grey(). Throws UserError naming the file
/// where it is no image.
[[nodiscard]] cv::Mat1b read_values(const std::filesystem::path& file);

/// Nine numbers, row by row. Throws UserError naming the file where they are no homography.
[[nodiscard]] cv::Matx33d read_homography(const std::filesystem::path& file);

}  // namespace striate::evaluation
