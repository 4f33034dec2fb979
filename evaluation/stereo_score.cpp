#include "striate/evaluation/stereo_score.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::evaluation {

StereoScore judge(const cv::Mat1f& disparity_px, const cv::Mat1f& truth_px) {
  int known = 0, judged = 0, wrong1 = 0, wrong2 = 0;
  for (int y = 0; y < truth_px.rows; ++y) {
    for (int x = 0; x < truth_px.cols; ++x) {
      if (!std::isfinite(truth_px(y, x))) continue;
      ++known;
      if (!std::isfinite(disparity_px(y, x))) continue;
      ++judged;
      const float error = std::abs(disparity_px(y, x) - truth_px(y, x));
      wrong1 += error > 1.0F;
      wrong2 += error > 2.0F;
    }
  }
  const double share = 100.0 / std::max(1, judged);
  return {wrong1 * share, wrong2 * share, 100.0 * judged / std::max(1, known)};
}

void Calibration::add(const cv::Mat1f& disparity_px, const cv::Mat1f& confidence,
                      const cv::Mat1f& truth_px) {
  for (int y = 0; y < truth_px.rows; ++y) {
    for (int x = 0; x < truth_px.cols; ++x) {
      if (!std::isfinite(truth_px(y, x)) || !std::isfinite(disparity_px(y, x))) continue;
      const int bin = cut_within(confidence(y, x) * kBins, 0, kBins - 1);
      auto count = [&](Bin& to) {
        ++to.count;
        to.right += std::abs(disparity_px(y, x) - truth_px(y, x)) <= 1.0F;
        to.confidence_sum += confidence(y, x);
      };
      count(bins_[static_cast<std::size_t>(bin)]);
      if (std::abs(confidence(y, x) - 0.9F) <= 0.03F) count(ninety_);
    }
  }
}

}  // namespace striate::evaluation
