#include "striate/agent/baselines/sgbm_disparity.hpp"

#include <opencv2/imgproc.hpp>

#include "striate/perception/stereo/stereo_matcher.hpp"

namespace striate::agent {
namespace {

/// StereoSGBM tells none: just below the 94 % that are right within 2 px (tests/evaluation)
constexpr float kTrust = 0.9F;
constexpr float kSteps = 16.0F;  // of StereoSGBM, a pixel of disparity

cv::Mat1b with_left_border(const cv::Mat1b& image, int columns) {
  cv::Mat1b wider;
  cv::copyMakeBorder(image, wider, 0, 0, columns, 0, cv::BORDER_REPLICATE);
  return wider;
}

}  // namespace

SgbmDisparity::SgbmDisparity(const perception::StereoSettings& settings)
    : width_(settings.width),
      searched_((settings.searched() + 15) / 16 * 16),
      matcher_(cv::StereoSGBM::create(0, searched_, 3, 8 * 9, 32 * 9, 1, 63, 10, 100, 2,
                                      cv::StereoSGBM::MODE_SGBM)) {}

// StereoSGBM gives nothing in the first columns, as many as it searches: they are put on before.
void SgbmDisparity::measure(const StereoFrame& frame, perception::DisparityMap& map) {
  cv::Mat1s sixteenths;
  matcher_->compute(with_left_border(perception::to_working_size(frame.left, width_), searched_),
                    with_left_border(perception::to_working_size(frame.right, width_), searched_),
                    sixteenths);
  const cv::Mat1s own = sixteenths.colRange(searched_, sixteenths.cols);
  map.disparity_px.create(own.size());
  map.confidence.create(own.size());
  for (int v = 0; v < own.rows; ++v) {
    for (int u = 0; u < own.cols; ++u) {
      const bool trusted = own(v, u) >= 0;
      map.disparity_px(v, u) =
          trusted ? static_cast<float>(own(v, u)) / kSteps : perception::kNoMatch;
      map.confidence(v, u) = trusted ? kTrust : 0.0F;
    }
  }
}

}  // namespace striate::agent
