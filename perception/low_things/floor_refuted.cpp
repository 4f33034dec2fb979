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

/// Mean square over each patch of left(u) - right(u - shift).
cv::Mat1f left_over(const cv::Mat1f& left, const cv::Mat1f& right, int shift) {
  cv::Mat1f square(left.size(), 0.0F);
  for (int v = 0; v < left.rows; ++v) {
    const float* l = left[v];
    const float* r = right[v];
    float* to = square[v];
    for (int u = shift; u < left.cols; ++u) to[u] = (l[u] - r[u - shift]) * (l[u] - r[u - shift]);
  }
  cv::Mat1f mean;
  cv::boxFilter(square, mean, CV_32F, kPatch, {-1, -1}, true, cv::BORDER_REPLICATE);
  return mean;
}

/// Disparities to the nearest pixel, -1 where there is none. @param most grows to the largest
cv::Mat1i whole_shifts(const cv::Mat1f& moved, int& most) {
  cv::Mat1i shifts(moved.size(), -1);
  for (int v = 0; v < moved.rows; ++v) {
    for (int u = 0; u < moved.cols; ++u) {
      if (!std::isfinite(moved(v, u))) continue;
      shifts(v, u) = round_within(moved(v, u), 0, moved.cols - 1);
      most = std::max(most, shifts(v, u));
    }
  }
  return shifts;
}

}  // namespace

cv::Mat1f floor_refuted_by(const FloorBand& band, const cv::Mat1f& moved, double floor_px) {
  cv::Mat1f refuted(moved.size(), 1.0F);
  const int at_floor = round_within(floor_px, 0, moved.cols - 1);
  int most = at_floor;
  const cv::Mat1i shifts = whole_shifts(moved, most);
  if (most == at_floor) return refuted;
  const cv::Mat1f left = without_mean(band.left);
  const cv::Mat1f right = without_mean(band.right);
  const cv::Mat1f on_floor = left_over(left, right, at_floor);
  for (int shift = at_floor + 1; shift <= most; ++shift) {
    const cv::Mat1f here = left_over(left, right, shift);
    for (int v = 0; v < moved.rows; ++v) {
      for (int u = 0; u < moved.cols; ++u) {
        if (shifts(v, u) != shift) continue;
        refuted(v, u) = (on_floor(v, u) + kLeastLeft) / (here(v, u) + kLeastLeft);
      }
    }
  }
  return refuted;
}

}  // namespace striate::perception
