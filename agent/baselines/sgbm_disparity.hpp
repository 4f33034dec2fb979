#pragma once

#include <opencv2/calib3d.hpp>

#include "striate/perception/stereo/disparity_source.hpp"
#include "striate/perception/stereo/stereo_settings.hpp"

namespace striate::agent {

/// OpenCV's StereoSGBM (mode SGBM, block 3, as in `striate eval stereo`) at the working size. It
/// has no confidence of its own: what it keeps after its checks counts as 0.9.
class SgbmDisparity final : public perception::DisparitySource {
 public:
  explicit SgbmDisparity(const perception::StereoSettings& settings);
  void measure(const StereoFrame& frame, perception::DisparityMap& map) override;

 private:
  int width_;
  int searched_;
  cv::Ptr<cv::StereoSGBM> matcher_;
};

}  // namespace striate::agent
