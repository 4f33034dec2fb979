#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "striate/evaluation/patch_set.hpp"

namespace striate::evaluation {

/// A way to describe patches, at one of several sizes of the frame.
struct PatchMethod {
  std::string name;
  std::vector<double> sizes_px;  ///< diameters tried; the best is reported
  /// One mosaic and the number of patches on it -> one row a patch: CV_8U for bits (Hamming
  /// distance), CV_32F for Euclidean distance. A row may hold several descriptions of the patch.
  std::function<cv::Mat(const cv::Mat1b& mosaic, int patches, double size_px)> describe;
  int descriptions = 1;  ///< in a row; the distance of two patches is that of the nearest two
};

/// ORB, BRISK, AKAZE and SIFT of OpenCV with the frames' orientation as given.
[[nodiscard]] std::vector<PatchMethod> opencv_patch_methods();

/// The distance of each pair of the set.
[[nodiscard]] std::vector<float> pair_distances(const PatchSet& set, const PatchMethod& method,
                                                double size_px);

/// Share of false pairs accepted where `recall` of the true ones are, 0..1.
[[nodiscard]] double false_positive_rate(const std::vector<PatchPair>& pairs,
                                         const std::vector<float>& distances, double recall);

}  // namespace striate::evaluation
