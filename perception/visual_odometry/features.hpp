#pragma once

#include <cstdint>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace striate::perception {

/// A keypoint as visual odometry wants it.
struct Feature {
  double u_px = 0.0;
  double v_px = 0.0;
  /// 1 for the finest keypoints; the error of a place grows with it
  double scale = 1.0;
  double response = 0.0;
};

enum class DescriptorMetric {
  hamming,   ///< differing bits
  euclidean  ///< of bytes
};

/// Keypoints of one image with a descriptor each, of any kind.
struct FeatureSet {
  std::vector<Feature> features;
  DescriptorMetric metric = DescriptorMetric::hamming;
  int bytes = 32;                         ///< of a descriptor; a multiple of 8
  std::vector<std::uint8_t> descriptors;  ///< one after the other
  double most_distance = 0.0;             ///< beyond it two are never of one thing

  [[nodiscard]] std::size_t size() const { return features.size(); }
};

/// Of two descriptors of the same kind.
[[nodiscard]] double descriptor_distance(const FeatureSet& a, std::size_t i, const FeatureSet& b,
                                         std::size_t j);

/// Finds and describes at most so many keypoints, spread over the image (spread_evenly()). The same
/// image must give the same features.
using FeatureSource = std::function<void(const cv::Mat1b& grey, int most, FeatureSet& features)>;

/// Which to keep, so that `most` or less remain and no part of the image has them all: of a grid of
/// cells each in turn gives its strongest that is left. In the order of `features`.
[[nodiscard]] std::vector<std::size_t> spread_evenly(const std::vector<Feature>& features,
                                                     cv::Size image, int most);

}  // namespace striate::perception
