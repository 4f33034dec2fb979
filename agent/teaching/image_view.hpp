#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/records.hpp"
#include "striate/perception/percept.hpp"

namespace striate::agent {

/// The keypoints that teach from an image and recognise in one: the only place that says which.
[[nodiscard]] std::vector<perception::Keypoint> keypoints_to_learn(const cv::Mat1b& grey);

/// A picture at the size that views are taught at: larger ones than 640 px are shrunk.
[[nodiscard]] cv::Mat3b picture_to_learn(const cv::Mat3b& image);

/// A view of what an image shows, with the image itself as JPEG. Larger images than 640 px are
/// shrunk first; of too many keypoints the strongest of each size stay.
/// @param inside of the image's size: keypoints are taken where it is not 0; empty: everywhere
[[nodiscard]] memory::StoredView view_of_image(const cv::Mat3b& image,
                                               const memory::LongTermSettings& settings,
                                               const cv::Mat1b& inside = {});

}  // namespace striate::agent
