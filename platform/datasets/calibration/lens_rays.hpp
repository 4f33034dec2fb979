#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

#include "striate/platform/datasets/calibration/camera_model.hpp"

namespace striate::datasets {

/// Where a lens shows rays, given as (x/z, y/z) in the camera's own frame: px of its picture.
[[nodiscard]] std::vector<cv::Point2d> shown_at(const EyeModel& eye,
                                                const std::vector<cv::Point2d>& rays);

/// The ray that a pixel sees. @return (x/z, y/z)
[[nodiscard]] cv::Point2d ray_of(const EyeModel& eye, cv::Point2d pixel);

/// Whether each ray is seen within the picture, and on the way out to it the lens never turns back:
/// a polynomial that was fitted to the picture may fold what lies beyond it back in.
[[nodiscard]] bool all_seen(const EyeModel& eye, const std::vector<cv::Point2d>& rays);

}  // namespace striate::datasets
