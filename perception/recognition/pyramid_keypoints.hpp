#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "perception/keypoints/keypoints.hpp"

namespace striate {

struct PyramidSettings {
  KeypointSettings keypoints{.threshold = 0.02, .most = 800};  ///< of each level
  double descriptor_wavelength_px = 12.0;  ///< of the cells that describe, in pixels of the level
  double descriptor_sigma_factor = 0.40;   ///< of their envelope; the paper's is 0.56
  int levels = 5;                          ///< each smaller by the square root of two
  int least_side_px = 48;                  ///< smaller levels are left out
};

/// Keypoints at several scales: the same cells on a pyramid of pictures. A keypoint's wavelength is
/// that of its level, in the picture that was handed in. Deviation from the paper, which describes
/// a keypoint by the cells that found it: here by larger ones with a narrower envelope, computed on
/// the level at half its size; they tell more.
class PyramidKeypoints {
 public:
  /// Throws UserError for settings out of range.
  explicit PyramidKeypoints(const PyramidSettings& settings);

  /// By level, then strongest first. An empty picture throws std::invalid_argument.
  [[nodiscard]] std::vector<Keypoint> operator()(const cv::Mat1b& grey);

 private:
  void describe(const cv::Mat1b& level, std::vector<Keypoint>& points);

  PyramidSettings settings_;
  KeypointFinder finder_;
  V1Cells cells_;
  V1Responses responses_;
};

}  // namespace striate
