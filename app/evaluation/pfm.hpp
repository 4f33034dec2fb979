#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace striate {

/// A grey PFM picture ("Pf"), upright; either byte order. Throws UserError for what is not one:
/// colour, sizes out of 1 .. 20000, a file that ends too early.
[[nodiscard]] cv::Mat1f read_pfm(const std::filesystem::path& path);

}  // namespace striate
