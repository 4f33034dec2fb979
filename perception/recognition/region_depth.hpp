#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// Median of the trusted disparities in a box of the working image; 0 where less than a tenth of
/// it is known, else the distance would be that of a stray pixel.
/// @param buffer kept between calls, so that nothing is allocated
[[nodiscard]] double median_disparity_px(const DisparityMap& map, const cv::Rect2d& box,
                                         std::vector<float>& buffer);

}  // namespace striate::perception
