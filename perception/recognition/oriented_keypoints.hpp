#pragma once

#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "striate/perception/descriptor/striate_descriptor.hpp"
#include "striate/perception/keypoints/keypoints.hpp"

namespace striate::perception {

struct OrientedSettings {
  /// Which keypoints: all sizes from fine to coarse.
  KeypointSettings keypoints{.wavelength_px = 4.0,
                             .halve = false,
                             .scales = 9,
                             .threshold = 0.01,
                             .fine_first = 0.5,
                             .most = 1500};
  double size_per_wavelength = 0.84;  ///< diameter of the described frame over lambda
  bool second_angle = true;           ///< keypoints with two directions stand twice
};

/// Keypoints for recognition: end-stopped cells at many scales say where, Striate's own descriptor
/// (../descriptor) says what and which way it is turned. Keeps its buffers.
class OrientedKeypoints {
 public:
  /// Throws UserError for settings out of range.
  explicit OrientedKeypoints(const OrientedSettings& settings);

  /// Strongest first. An empty image throws std::invalid_argument.
  void find(const cv::Mat1b& grey, std::vector<Keypoint>& out);
  /// Describes keypoints that were found elsewhere (those of a salient region, say) in `grey`.
  /// @param out in the same order; those with two directions stand twice. Must not be `found`.
  void describe(const cv::Mat1b& grey, std::span<const Keypoint> found, std::vector<Keypoint>& out);
  [[nodiscard]] std::vector<Keypoint> operator()(const cv::Mat1b& grey);

 private:
  OrientedSettings settings_;
  KeypointFinder finder_;
  StriateDescriber describer_;
  std::vector<Keypoint> found_;
  std::vector<DescribedFrame> frames_, turned_;
  std::vector<Descriptor> descriptors_;
};

}  // namespace striate::perception
