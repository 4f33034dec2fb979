#pragma once

#include <filesystem>
#include <istream>
#include <opencv2/core/mat.hpp>
#include <string>

namespace striate::evaluation {

/// A grey PFM file ("Pf", width, height, scale; rows bottom up), as upright CV_32F. A negative
/// scale means little-endian, a positive one big-endian; its size is not applied, as is customary
/// for disparities. NaN becomes +inf (unknown), as in Middlebury; infinities stay. Throws
/// UserError, naming `name`, for anything else: colour ("PF"), more than 16384 px a side or 40
/// million pixels, a scale of zero or not finite, too few bytes.
[[nodiscard]] cv::Mat1f read_pfm(std::istream& in, const std::string& name);
[[nodiscard]] cv::Mat1f read_pfm(const std::filesystem::path& file);

}  // namespace striate::evaluation
