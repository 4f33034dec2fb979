#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace striate::evaluation {

/// Two images of one flat scene.
struct ImagePair {
  cv::Size first, second;
  cv::Matx33d to_second;  ///< from the first's pixels to the second's
};

/// How many keypoints of one image come again in the other.
struct Repeatability {
  int common = 0;    ///< keypoints in what both images show: the lesser of the two numbers
  int repeated = 0;  ///< of these, paired one to one
  [[nodiscard]] double share() const {
    return common > 0 ? static_cast<double>(repeated) / common : 0.0;
  }
};

/// Places alone are compared, not sizes: a keypoint is repeated when its place, mapped to the
/// second image, is within `tolerance_px` of a keypoint there; the nearest pairs are made first
/// and each keypoint is used once. (Mikolajczyk et al. 2005 compare regions instead.)
[[nodiscard]] Repeatability repeatability(const std::vector<cv::Point2d>& first,
                                          const std::vector<cv::Point2d>& second,
                                          const ImagePair& pair, double tolerance_px);

}  // namespace striate::evaluation
