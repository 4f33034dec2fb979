#pragma once

#include <vector>

#include "striate/perception/descriptor/striate_descriptor.hpp"
#include "striate/perception/keypoints/keypoints.hpp"
#include "striate/perception/visual_odometry/features.hpp"

namespace striate::perception {

/// Which V1 keypoints serve odometry: fine ones, whose places are exact, and a few coarser ones,
/// which outlast blur. Upright descriptors: from image to image the head hardly rolls.
struct StriateFeatureSettings {
  KeypointSettings keypoints{.wavelength_px = 4.0,
                             .halve = false,
                             .scales = 5,
                             .threshold = 0.01,
                             .fine_first = 0.5,
                             // more than are ever kept, so that all parts of the image have some
                             .most = 4000};
  double size_per_wavelength =
      0.84;  ///< diameter of the described frame over lambda, as recognition's
  double most_distance_bits = 80.0;  ///< of 256: true pairs are usually below (by hand)
};

/// V1 keypoints with Striate's own descriptor. Keeps its buffers.
class StriateFeatures {
 public:
  explicit StriateFeatures(const StriateFeatureSettings& settings = {});
  void operator()(const cv::Mat1b& grey, int most, FeatureSet& features);

 private:
  StriateFeatureSettings settings_;
  KeypointFinder finder_;
  StriateDescriber describer_;
  std::vector<Keypoint> found_;
  std::vector<DescribedFrame> frames_;
  std::vector<Descriptor> descriptors_;
};

/// As a source that may be copied; copies share the buffers.
[[nodiscard]] FeatureSource striate_features(const StriateFeatureSettings& settings = {});

}  // namespace striate::perception
