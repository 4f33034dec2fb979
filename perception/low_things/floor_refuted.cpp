#include "striate/perception/low_things/floor_refuted.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

const cv::Size kPatch{9, 7};  // px of the finer size: 5 cm across 2 m away (ours)
/// Squares of sixteenths of a grey level that noise leaves at least: a quarter of a level
constexpr float kLeastLeft = 16.0F;

/// Without the mean of the patch: the eyes differ in gain, and towards their borders in brightness.
cv::Mat1f without_mean(const cv::Mat1w& image) {
  cv::Mat1f grey;
  image.convertTo(grey, CV_32F);
  cv::Mat1f mean;
  cv::boxFilter(grey, mean, CV_32F, kPatch, {-1, -1}, true, cv::BORDER_REPLICATE);
  return grey - mean;
}

}  // namespace

FloorRefutation::FloorRefutation(const FloorBand& band, double floor_px)
    : left_(without_mean(band.left)),
      right_(without_mean(band.right)),
      floor_px_(round_within(floor_px, 0, band.left.cols - 1)) {}

/// Mean square over the patch of left(u) - right(u - shift); the outermost pixels stand for what is
/// beyond them.
float FloorRefutation::left_over(int row, int column, int shift_px) const {
  double sum = 0.0;
  for (int dv = -kPatch.height / 2; dv <= kPatch.height / 2; ++dv) {
    const int v = std::clamp(row + dv, 0, left_.rows - 1);
    const float* l = left_[v];
    const float* r = right_[v];
    for (int du = -kPatch.width / 2; du <= kPatch.width / 2; ++du) {
      const int u = std::clamp(column + du, 0, left_.cols - 1);
      if (u < shift_px) continue;  // seen by the left eye alone
      const float difference = l[u] - r[u - shift_px];
      sum += static_cast<double>(difference * difference);
    }
  }
  return static_cast<float>(sum / kPatch.area());
}

float FloorRefutation::at(int row, int column, float disparity_px) const {
  const int shift_px = round_within(disparity_px, 0, left_.cols - 1);
  return (left_over(row, column, floor_px_) + kLeastLeft) /
         (left_over(row, column, shift_px) + kLeastLeft);
}

}  // namespace striate::perception
