#include "striate/perception/descriptor/v1_scales.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace striate::perception {
namespace {

/// Half a V1 kernel (15 px at lambda = 3): a smaller image shows it nothing
constexpr int kSmallestScaleSide_px = 8;
/// One octave finer than the image: an enlargement holds nothing more
constexpr int kFinestLevel = -V1Scales::kPerOctave;

}  // namespace

void V1Scales::prepare(const cv::Mat1b& grey) {
  if (grey.empty()) throw std::invalid_argument("V1Scales: the image is empty");
  if (halvings_.empty()) halvings_.resize(1);
  grey.copyTo(halvings_[0]);
  halved_ = 1;
  while (true) {
    const auto last = static_cast<std::size_t>(halved_ - 1);
    // An odd last row or column is left out: pixels must stay where they are.
    const cv::Size half(halvings_[last].cols / 2, halvings_[last].rows / 2);
    if (std::min(half.width, half.height) < kSmallestScaleSide_px) return;
    if (halvings_.size() == last + 1) halvings_.emplace_back();
    cv::resize(halvings_[last](cv::Rect({0, 0}, half * 2)), halvings_[last + 1], half, 0, 0,
               cv::INTER_AREA);
    ++halved_;
  }
}

int V1Scales::level_of(double step_px) const {
  const long level = std::lround(kPerOctave * std::log2(step_px));
  return static_cast<int>(
      std::clamp(level, static_cast<long>(kFinestLevel), static_cast<long>(kPerOctave) * halved_));
}

V1Field V1Scales::respond(int level, const cv::Rect2d& box) {
  if (halved_ == 0) throw std::invalid_argument("V1Scales: no image was prepared");
  const double step_px = std::exp2(static_cast<double>(level) / kPerOctave);
  const int half = std::clamp((level + kPerOctave / 2) / kPerOctave, 0, halved_ - 1);
  const cv::Mat1b& from = halvings_[static_cast<std::size_t>(half)];
  const double halved_px = std::ldexp(1.0, half);
  const cv::Size size(std::max(1, static_cast<int>(std::lround(from.cols * halved_px / step_px))),
                      std::max(1, static_cast<int>(std::lround(from.rows * halved_px / step_px))));
  cv::resize(from, resized_, size, 0, 0, cv::INTER_LINEAR);
  const int reach = reach_px_ + cells_.bank().radius + 1;
  cv::copyMakeBorder(resized_, padded_, reach, reach, reach, reach, cv::BORDER_REPLICATE);
  V1Field field;
  field.responses = &responses_;
  field.zoom_u = from.cols * halved_px / size.width;
  field.zoom_v = from.rows * halved_px / size.height;
  field.whole = size;
  const int left = static_cast<int>(field.u_of(box.x));
  const int top = static_cast<int>(field.v_of(box.y));
  const int right = static_cast<int>(field.u_of(box.x + box.width));
  const int bottom = static_cast<int>(field.v_of(box.y + box.height));
  field.left = left - reach;
  field.top = top - reach;
  // The padded image begins `reach` before the image.
  const cv::Rect part(left, top, right - left + 2 * reach + 1, bottom - top + 2 * reach + 1);
  cells_.respond_simple(padded_(part), SimpleCells::odd, responses_);
  return field;
}

}  // namespace striate::perception
