#include "striate/perception/stereo/decision.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

namespace striate::perception {
namespace {

/// Rows that the winner kernels write, in their order
constexpr int kBest = 0, kSmallest = 1, kSecond = 2, kRawSecond = 3, kRightBest = 4;
/// Bits of 256 by which a match must beat others to be told from them: the noise of two eyes (ours)
constexpr int kClearMargin = 24;
/// Matches that differ in more bits are bad ones, in noise, not repeated ones (ours)
constexpr int kFairCost = 80;
constexpr int kPatternTexture = 14 * 2048;  // as StereoEvidence::texture: two grey levels
constexpr std::uint8_t kPattern = 2;        // of what is repeated: with so much contrast
const cv::Size kPatternWindow{17, 17};      // px of the working image
constexpr float kMostPattern = 0.75F;       // of the known pixels in it (ours)

}  // namespace

Decision::Decision(const RobustStereoSettings& settings)
    : settings_(settings), least_confidence_(static_cast<float>(settings.least_confidence)) {}

void Decision::find_winners(const Input& input, int y, const SmoothedCosts& smoothed) {
  const stereo_kernels::SmoothedRow from{
      smoothed.steep_sums, smoothed.sum_stride,  smoothed.level_means, smoothed.mean_stride,
      input.costs.line(y), input.outside.row(0), input.costs.width(),  input.candidates};
  stereo_kernels::find_winners(
      from, {sums_.row(0), sums_.stride(), winners_.row(kBest), winners_.row(kSmallest),
             winners_.row(kSecond), winners_.row(kRawSecond), winners_.row(kRightBest)});
}

/// The lowest point of two lines of equal and opposite slope through the three sums
/// ("equiangular"): less drawn to whole pixels than a parabola.
float Decision::sub_pixel(int best, int x, int limit) const {
  const auto whole = static_cast<float>(best);
  if (best == 0 || best + 1 >= limit) return whole;
  const int below = sums_.row(best - 1)[x], at = sums_.row(best)[x], above = sums_.row(best + 1)[x];
  const int slope = std::max(below, above) - at;
  if (slope <= 0) return whole;
  return whole + 0.5F * static_cast<float>(below - above) / static_cast<float>(slope);
}

void Decision::decide_row(const Input& input, int y, const SmoothedCosts& smoothed,
                          DisparityMap& out) {
  find_winners(input, y, smoothed);
  std::array<const std::int16_t*, kOrientations> responses{};
  for (std::size_t i = 0; i < kOrientations; ++i) responses[i] = input.left.code[i].row(y);
  stereo_kernels::largest_of_rows(responses, input.costs.width(), strongest_.row(0));
  const int width = input.costs.width(), stride = input.costs.stride();
  const std::uint8_t* costs = input.costs.line(y);
  const std::int16_t* strongest = strongest_.row(0);
  const std::uint16_t *bests = winners_.row(kBest), *right_bests = winners_.row(kRightBest);
  const std::uint16_t *smallest = winners_.row(kSmallest), *second = winners_.row(kSecond);
  const std::uint16_t* raw_second = winners_.row(kRawSecond);
  float* disparities = out.disparity_px.ptr<float>(y);
  float* confidences = out.confidence.ptr<float>(y);
  std::uint8_t* repeated = repeated_[y];
  for (int x = 0; x < width; ++x) {
    disparities[x] = kNoMatch;
    confidences[x] = 0.0F;
    repeated[x] = 0;
    const int best = bests[x];
    if (std::abs(right_bests[x - best] - best) > settings_.left_right_px) continue;
    const int cost = costs[best * stride + x];
    const float sure = stereo_confidence({second[x] - smallest[x], smallest[x],
                                          raw_second[x] - cost, cost, strongest[x] + 32768, best},
                                         settings_.confidence);
    if (sure <= 0.0F || sure < least_confidence_) continue;
    disparities[x] = sub_pixel(best, x, std::min(input.candidates, x + 1));
    confidences[x] = sure;
    if (raw_second[x] - cost >= kClearMargin || cost >= kFairCost) continue;
    repeated[x] = strongest[x] + 32768 < kPatternTexture ? 1 : kPattern;
  }
}

void Decision::begin(const Input& input) {
  const int width = input.costs.width();
  repeated_.create(input.left.code[0].height(), width);
  const int old_stride = sums_.stride(), old_height = sums_.height();
  sums_.resize(width, input.candidates, input.candidates + 64, 0);
  winners_.resize(width, 5, 0, 0);
  strongest_.resize(width, 1, 0, 0);
  if (sums_.stride() != old_stride || sums_.height() != old_height) {
    for (int d = 0; d < input.candidates; ++d) {
      std::uint16_t* row = sums_.row(d);
      std::fill(row, row - sums_.margin() + sums_.stride(), std::uint16_t{65535});
    }
  }
}

/// Slats, a chessboard: well seen, and the same again beside it. What surrounds a pixel of them can
/// drag all of it to a wrong repeat, which may lie on one surface with what is behind.
void Decision::drop_patterns(DisparityMap& out) {
  cv::compare(repeated_, kPattern, counted_, cv::CMP_EQ);  // 255 or 0
  cv::boxFilter(counted_, pattern_share_, CV_32F, kPatternWindow);
  cv::compare(out.disparity_px, kNoMatch, counted_, cv::CMP_NE);
  cv::boxFilter(counted_, known_share_, CV_32F, kPatternWindow);
  for (int y = 0; y < out.disparity_px.rows; ++y) {
    for (int x = 0; x < out.disparity_px.cols; ++x) {
      if (pattern_share_(y, x) <= kMostPattern * known_share_(y, x)) continue;
      out.disparity_px(y, x) = kNoMatch;
      out.confidence(y, x) = 0.0F;
    }
  }
}

void Decision::finish(DisparityMap& out) {
  drop_patterns(out);
  speckles_.drop(settings_.speckle_px, repeated_, out);
  gaps_.fill({(settings_.fill_gap_px * out.disparity_px.cols + 80) / 160, least_confidence_}, out);
}

}  // namespace striate::perception
