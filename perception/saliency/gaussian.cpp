#include "striate/perception/saliency/gaussian.hpp"

#include <opencv2/imgproc.hpp>

namespace striate::perception {

Gaussian::Gaussian(double sigma_px)
    : sigma_px_(sigma_px),
      // Four sigma to each side, as cv::GaussianBlur takes for floats.
      kernel_(cv::getGaussianKernel(cvRound(sigma_px * 8.0 + 1.0) | 1, sigma_px, CV_32F)) {}

void Gaussian::blur(const cv::Mat& in, cv::Mat& out) const {
  cv::sepFilter2D(in, out, CV_32F, kernel_, kernel_, {-1, -1}, 0.0, cv::BORDER_REFLECT);
}

}  // namespace striate::perception
