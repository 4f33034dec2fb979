#include "perception/stereo/decision.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace striate {
namespace {

constexpr int kBest = 0, kSmallest = 1, kSecond = 2, kRawSecond = 3, kRightBest = 4;

int strongest_response(const V1Responses& responses, int y, int x) {
  int strongest = -32768;
  for (const Plane<std::int16_t>& plane : responses.code) {
    strongest = std::max<int>(strongest, plane.row(y)[x]);
  }
  return strongest + 32768;
}

}  // namespace

Decision::Decision(const RobustStereoSettings& settings)
    : settings_(settings), least_confidence_(static_cast<float>(settings.least_confidence)) {}

void Decision::find_winners(const Input& input, int y) {
  const Volume<std::uint16_t>& steep = input.smoothed.steep_sums();
  const Volume<std::uint8_t>& level = input.smoothed.level_means();
  const stereo_kernels::SmoothedRow from{
      steep.line(y),       steep.stride(),       level.line(y),       level.stride(),
      input.costs.line(y), input.outside.row(0), input.costs.width(), input.candidates};
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

/// As the settings measure it; 0 where the evidence says nothing.
float Decision::confidence(const StereoEvidence& evidence) const {
  const float score = stereo_score(evidence);
  if (score <= 0.0F || settings_.confidence == StereoConfidence::score) return score;
  return promise_of(score);
}

void Decision::decide_row(const Input& input, int y, DisparityMap& out) {
  const int width = input.costs.width();
  const std::uint8_t* costs = input.costs.line(y);
  float* disparities = out.disparity_px.ptr<float>(y);
  float* confidences = out.confidence.ptr<float>(y);
  for (int x = 0; x < width; ++x) {
    disparities[x] = kNoMatch;
    confidences[x] = 0.0F;
    const int best = winners_.row(kBest)[x];
    const int smallest = winners_.row(kSmallest)[x];
    const int second = winners_.row(kSecond)[x];
    if (std::abs(winners_.row(kRightBest)[x - best] - best) > settings_.left_right_px) continue;
    const int cost = costs[best * input.costs.stride() + x];
    const float sure = confidence({second - smallest, smallest, winners_.row(kRawSecond)[x] - cost,
                                   cost, strongest_response(input.left, y, x)});
    if (sure <= 0.0F || sure < least_confidence_) continue;
    disparities[x] = sub_pixel(best, x, std::min(input.candidates, x + 1));
    confidences[x] = sure;
  }
}

/// Connected pieces, neighbours at most 1 px apart, that are too small to be things.
void Decision::drop_speckles(DisparityMap& out) {
  const int width = out.disparity_px.cols, height = out.disparity_px.rows;
  auto* disparities = out.disparity_px.ptr<float>();
  seen_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  for (int start = 0; start < width * height; ++start) {
    if (seen_[static_cast<std::size_t>(start)] != 0 || disparities[start] == kNoMatch) continue;
    piece_.assign(1, start);
    seen_[static_cast<std::size_t>(start)] = 1;
    for (std::size_t at = 0; at < piece_.size(); ++at) {
      const int here = piece_[at];
      auto join = [&](bool inside, int there) {
        if (!inside || seen_[static_cast<std::size_t>(there)] != 0) return;
        if (!(std::abs(disparities[there] - disparities[here]) <= 1.0F)) return;
        seen_[static_cast<std::size_t>(there)] = 1;
        piece_.push_back(there);
      };
      join(here % width > 0, here - 1);
      join(here % width < width - 1, here + 1);
      join(here >= width, here - width);
      join(here < width * (height - 1), here + width);
    }
    if (static_cast<int>(piece_.size()) >= settings_.speckle_px) continue;
    for (const int index : piece_) {
      disparities[index] = kNoMatch;
      out.confidence.ptr<float>()[index] = 0.0F;
    }
  }
}

void Decision::decide(const Input& input, DisparityMap& out) {
  const int width = input.costs.width();
  const int old_stride = sums_.stride(), old_height = sums_.height();
  sums_.resize(width, input.candidates, input.candidates + 64, 0);
  winners_.resize(width, 5, 0, 0);
  if (sums_.stride() != old_stride || sums_.height() != old_height) {
    for (int d = 0; d < input.candidates; ++d) {
      std::uint16_t* row = sums_.row(d);
      std::fill(row, row - sums_.margin() + sums_.stride(), std::uint16_t{65535});
    }
  }
  for (int y = 0; y < out.disparity_px.rows; ++y) {
    find_winners(input, y);
    decide_row(input, y, out);
  }
  drop_speckles(out);
  gaps_.fill({(settings_.fill_gap_px * width + 80) / 160, least_confidence_}, out);
}

}  // namespace striate
