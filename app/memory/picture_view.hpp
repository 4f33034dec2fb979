#pragma once

#include <opencv2/core/mat.hpp>

#include "memory/long_term/long_term_settings.hpp"
#include "memory/long_term/records.hpp"
#include "perception/percept.hpp"

namespace striate {

/// The keypoints that teach from a picture and recognise in one: the only place that says which.
[[nodiscard]] std::vector<Keypoint> keypoints_to_learn(const cv::Mat1b& grey);

/// A view of what a picture shows, with the picture itself as JPEG. Larger pictures than 640 px are
/// shrunk first; of too many keypoints the strongest stay.
[[nodiscard]] StoredView view_of_picture(const cv::Mat3b& picture,
                                         const LongTermSettings& settings);

}  // namespace striate
