#include "striate/perception/saliency/image_change.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::perception {
namespace {

/// Mean |difference| at every second pixel of every second row that both images show.
double mean_difference(const cv::Mat1f& now, const cv::Mat1f& before, cv::Point shift) {
  double sum = 0.0;
  int count = 0;
  for (int v = std::max(0, -shift.y); v < now.rows - std::max(0, shift.y); v += 2) {
    for (int u = std::max(0, -shift.x); u < now.cols - std::max(0, shift.x); u += 2) {
      sum += std::abs(now(v, u) - before(v + shift.y, u + shift.x));
      ++count;
    }
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

}  // namespace

void ImageChange::find_shift(const cv::Mat1f& grey) {
  const int most_u = std::min(kLongestShift_px, grey.cols / 4);
  const int most_v = std::min(kLongestShift_px, grey.rows / 4);
  shift_px_ = {0, 0};
  double best = mean_difference(grey, before_, shift_px_);
  for (int dv = -most_v; dv <= most_v; ++dv) {
    for (int du = -most_u; du <= most_u; ++du) {
      const double difference = mean_difference(grey, before_, {du, dv});
      if (difference < best) {
        best = difference;
        shift_px_ = {du, dv};
      }
    }
  }
}

void ImageChange::add(const cv::Mat1f& grey, cv::Mat1f& sum) {
  if (before_.size() != grey.size()) {
    grey.copyTo(before_);
    return;
  }
  find_shift(grey);
  change_.create(grey.size());
  for (int v = 0; v < grey.rows; ++v) {
    for (int u = 0; u < grey.cols; ++u) {
      const cv::Point was(u + shift_px_.x, v + shift_px_.y);
      const bool seen = was.x >= 0 && was.x < grey.cols && was.y >= 0 && was.y < grey.rows;
      change_(v, u) = seen ? std::abs(grey(v, u) - before_(was)) : 0.0F;
    }
  }
  change_.copyTo(sorted_);
  float* middle = sorted_[0] + sorted_.total() / 2;
  std::nth_element(sorted_[0], middle, sorted_[0] + sorted_.total());
  // Of |a normal| less than 18 % is above twice its median: most of what does not move is gone.
  constexpr float kNoise = 2.0F;
  const float noise = kNoise * *middle;
  for (int v = 0; v < grey.rows; ++v) {
    for (int u = 0; u < grey.cols; ++u) sum(v, u) += std::max(0.0F, change_(v, u) - noise);
  }
  grey.copyTo(before_);
}

}  // namespace striate::perception
