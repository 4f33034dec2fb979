#pragma once

#include <opencv2/core/mat.hpp>

namespace striate::perception {

/// A Gaussian blur whose kernel is made once: cv::GaussianBlur makes it anew in each call, in
/// software floating point, which takes longer than filtering planes of this size. The same bits
/// as cv::GaussianBlur on CV_32F with cv::BORDER_REFLECT.
class Gaussian {
 public:
  explicit Gaussian(double sigma_px);  ///< > 0
  /// `in` and `out` are CV_32F of any number of channels, and may be the same.
  void blur(const cv::Mat& in, cv::Mat& out) const;
  [[nodiscard]] double sigma_px() const { return sigma_px_; }

 private:
  double sigma_px_;
  cv::Mat kernel_;
};

}  // namespace striate::perception
