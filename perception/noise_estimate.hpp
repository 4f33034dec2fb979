#pragma once

#include <opencv2/core/mat.hpp>

namespace striate::perception {

/// Standard deviation of a pixel's noise in grey levels, after Immerkaer (1996): response to the
/// difference of two Laplacians, which is blind to planes and most edges; the median of its
/// magnitude in place of the mean, so that texture does not count as noise. 0 for images smaller
/// than 3x3.
[[nodiscard]] double estimate_noise(const cv::Mat1b& grey);

}  // namespace striate::perception
