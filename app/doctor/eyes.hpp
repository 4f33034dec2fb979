#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "striate/app/doctor/finding.hpp"
#include "striate/platform/pioneer/pioneer_settings.hpp"

namespace striate::app {

/// Whether a pair is one: the left eye left, the rows at the same height. A note where the images
/// show too little to tell. @param about the camera, as the other findings call it
[[nodiscard]] Finding look_at_pair_of(const std::string& about, const cv::Mat3b& left,
                                      const cv::Mat3b& right);

/// The first pair of a camera as the robot will see it, rectified where it has a calibration.
/// Nothing where none comes: others say so.
[[nodiscard]] Findings look_at_eyes(const pioneer::PioneerSettings& settings);

}  // namespace striate::app
