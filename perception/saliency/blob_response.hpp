#pragma once

#include <opencv2/core/mat.hpp>

namespace striate::perception {

/// Differences of Gaussians with sigma+ 5, 10 and 20 px and sigma- twice that, summed over scales.
/// A Gaussian of 5 px is computed at half size, 10 px at a quarter, 20 and 40 px at an eighth;
/// what area averaging has blurred already is taken off. Borders are mirrored.
enum class Rectify { half, both };  ///< max(0, x), or |x|: a map and its complement together

/// Adds the response of `plane` (half the working size) to `sum` (same size).
void add_blob_response(const cv::Mat1f& plane, Rectify rectify, cv::Mat1f& sum);

}  // namespace striate::perception
