#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "memory/long_term/records.hpp"

namespace striate::pictures {

/// The views of a landmark side by side, each with its picture and the circles of its keypoints.
/// Views without a picture, or with a damaged one, show the keypoints on grey.
[[nodiscard]] cv::Mat3b draw_views(const Landmark& landmark, const std::vector<StoredView>& views);

/// The map from above: obstacle grid, routes, landmarks with their names and 95 % ellipses. Map
/// x to the right, y up. Landmarks without a position are not on it.
[[nodiscard]] cv::Mat3b draw_memory_map(const std::vector<Landmark>& landmarks,
                                        const std::vector<Route>& routes,
                                        const std::vector<ObstacleCell>& cells);

}  // namespace striate::pictures
