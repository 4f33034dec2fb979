#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/memory/long_term/records.hpp"

namespace striate::agent::pictures {

/// The views of a landmark side by side, each with its image and the circles of its keypoints.
/// Views without an image, or with a damaged one, show the keypoints on grey.
[[nodiscard]] cv::Mat3b draw_views(const memory::Landmark& landmark,
                                   const std::vector<memory::StoredView>& views);

/// The map from above: obstacle grid, routes, landmarks with their names and 95 % ellipses. Map
/// x to the right, y up. Landmarks without a position are not on it.
[[nodiscard]] cv::Mat3b draw_memory_map(const std::vector<memory::Landmark>& landmarks,
                                        const std::vector<memory::Route>& routes,
                                        const std::vector<memory::ObstacleCell>& cells);

}  // namespace striate::agent::pictures
