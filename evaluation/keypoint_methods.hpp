#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "striate/perception/keypoints/keypoint_settings.hpp"

namespace striate::evaluation {

struct KeypointMethod {
  std::string name;
  /// Places of at most `most` keypoints, strongest first, none twice.
  std::function<std::vector<cv::Point2d>(const cv::Mat1b& grey, int most)> find;
};

/// lambda 4 to 64, two per octave, at full size.
[[nodiscard]] perception::KeypointSettings all_scales(perception::EndStoppedResponse response);

/// Striate's keypoints, and OpenCV's with thresholds low enough for 1000 points; BRISK with its own
/// threshold, with which it repeats better.
[[nodiscard]] std::vector<KeypointMethod> keypoint_methods();

}  // namespace striate::evaluation
