#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "perception/keypoints/keypoints.hpp"

namespace striate {

struct PyramidSettings {
  KeypointSettings keypoints;  ///< of each level
  int levels = 5;              ///< each smaller by the square root of two
  int least_side_px = 48;      ///< smaller levels are left out
};

/// Keypoints at several scales: the same cells on a pyramid of pictures. A keypoint's wavelength is
/// that of its level, in the picture that was handed in.
class PyramidKeypoints {
 public:
  explicit PyramidKeypoints(const PyramidSettings& settings);
  [[nodiscard]] std::vector<Keypoint> operator()(const cv::Mat1b& grey);

 private:
  PyramidSettings settings_;
  KeypointFinder finder_;
  cv::Mat1b level_;
};

}  // namespace striate
