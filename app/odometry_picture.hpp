#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/evaluation/odometry/eval_odometry.hpp"

namespace striate::app {

/// The true way and the aligned estimate from above (along the axis that the way goes least), one
/// scale for both axes; below it the error over the poses.
[[nodiscard]] cv::Mat3b draw_odometry(const evaluation::OdometryScores& scores);

}  // namespace striate::app
