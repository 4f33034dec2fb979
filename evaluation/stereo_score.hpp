#pragma once

#include <array>
#include <opencv2/core/mat.hpp>

namespace striate::evaluation {

struct StereoScore {
  double bad1 = 0.0;     ///< % of judged pixels that are wrong by more than 1 px
  double bad2 = 0.0;     ///< ... 2 px
  double density = 0.0;  ///< % of pixels with known truth that have a disparity
};

/// Judges finite disparities at pixels with finite truth.
[[nodiscard]] StereoScore judge(const cv::Mat1f& disparity_px, const cv::Mat1f& truth_px);

/// How often disparities are right, by the confidence that they came with.
class Calibration {
 public:
  static constexpr int kBins = 10;  ///< each a tenth of the confidence wide

  void add(const cv::Mat1f& disparity_px, const cv::Mat1f& confidence, const cv::Mat1f& truth_px);

  struct Bin {
    int count = 0;
    int right = 0;                ///< within 1 px
    double confidence_sum = 0.0;  ///< of all
  };
  [[nodiscard]] const std::array<Bin, kBins>& bins() const { return bins_; }
  /// Of those that are said to be right with 90 %: confidences of 0.87 to 0.93.
  [[nodiscard]] const Bin& ninety() const { return ninety_; }

 private:
  Bin ninety_;
  std::array<Bin, kBins> bins_;
};

}  // namespace striate::evaluation
