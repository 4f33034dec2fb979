#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace striate::evaluation {

/// 8 or 16 bit, grey, colour, with or without alpha, as 8-bit BGR: PNG, JPEG, PGM/PPM, BMP, TIFF
/// or WebP, whatever the file is called; sides of at least 16 px and at most 40 million pixels, one
/// side at most 20 times the other, judged by the header before anything is decoded. Throws
/// UserError naming the file for everything else, for floating-point pixels, and for a file that
/// was cut off.
[[nodiscard]] cv::Mat3b read_any_image(const std::filesystem::path& file);

}  // namespace striate::evaluation
