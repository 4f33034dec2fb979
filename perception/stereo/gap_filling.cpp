#include "striate/perception/stereo/gap_filling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace striate::perception {
namespace {

/// Ends that differ by more are not of one surface.
/// Ends that differ by more are not of one surface: two steps that P1 pays for (ours)
constexpr float kSameFilled_px = 2.0F;

struct End {
  int away_px = 0;  ///< from the pixel to be filled; 0: there is none, the image ends
  float disparity = 0.0F;
  float confidence = 0.0F;
};

/// A gap and what its pixel gets from it.
struct Bridge {
  int length_px = 0;  ///< 0: there is none
  GapKind kind = GapKind::border;
  float disparity = 0.0F;
  float confidence = 0.0F;  ///< of the less certain end that was used
};

Bridge cross(const End& a, const End& b, int length_px) {
  if (a.away_px == 0) return {length_px, GapKind::border, b.disparity, b.confidence};
  if (b.away_px == 0) return {length_px, GapKind::border, a.disparity, a.confidence};
  if (std::abs(a.disparity - b.disparity) > kSameFilled_px) {
    const End& farther = a.disparity < b.disparity ? a : b;
    return {length_px, GapKind::step, farther.disparity, farther.confidence};
  }
  const float share = static_cast<float>(a.away_px) / static_cast<float>(a.away_px + b.away_px);
  const float between = a.disparity + share * (b.disparity - a.disparity);
  return {length_px, GapKind::surface, between, std::min(a.confidence, b.confidence)};
}

const Bridge& better(const Bridge& a, const Bridge& b) {
  if (a.length_px == 0 || b.length_px == 0) return a.length_px == 0 ? b : a;
  if ((a.kind == GapKind::surface) != (b.kind == GapKind::surface)) {
    return a.kind == GapKind::surface ? a : b;
  }
  return b.length_px < a.length_px ? b : a;
}

}  // namespace

void GapFilling::measure_columns() {
  const int width = disparity_px_.cols, height = disparity_px_.rows;
  up_.create(height, width);
  down_.create(height, width);
  auto measure = [&](cv::Mat1i& nearest, int y, int before) {
    const float* disparities = disparity_px_.ptr<float>(y);
    const int* last = before < 0 || before >= height ? nullptr : nearest.ptr<int>(before);
    int* here = nearest.ptr<int>(y);
    for (int x = 0; x < width; ++x) {
      const int earlier = last == nullptr ? before : last[x];
      here[x] = disparities[x] == kNoMatch ? earlier : y;
    }
  };
  for (int y = 0; y < height; ++y) measure(up_, y, y - 1);
  for (int y = height - 1; y >= 0; --y) measure(down_, y, y + 1);
}

void GapFilling::measure_row(int y) {
  const float* disparities = disparity_px_.ptr<float>(y);
  const int width = disparity_px_.cols;
  left_.resize(static_cast<std::size_t>(width));
  right_.resize(static_cast<std::size_t>(width));
  for (int x = 0, known = -1; x < width; ++x) {
    if (disparities[x] != kNoMatch) known = x;
    left_[static_cast<std::size_t>(x)] = known;
  }
  for (int x = width - 1, known = width; x >= 0; --x) {
    if (disparities[x] != kNoMatch) known = x;
    right_[static_cast<std::size_t>(x)] = known;
  }
}

void GapFilling::fill(const GapSettings& settings, DisparityMap& map) {
  const int longest_px = settings.longest_px;
  if (longest_px <= 0) return;
  map.disparity_px.copyTo(disparity_px_);
  map.confidence.copyTo(confidence_);
  measure_columns();
  const int width = disparity_px_.cols, height = disparity_px_.rows;
  auto end = [&](int x, int y, int away_px) {
    if (x < 0 || y < 0 || x >= width || y >= height) return End{};
    return End{away_px, disparity_px_(y, x), confidence_(y, x)};
  };
  for (int y = 0; y < height; ++y) {
    measure_row(y);
    for (int x = 0; x < width; ++x) {
      if (disparity_px_(y, x) != kNoMatch) continue;
      const int left = left_[static_cast<std::size_t>(x)];
      const int right = right_[static_cast<std::size_t>(x)];
      const int up = up_(y, x), down = down_(y, x);
      Bridge across, along;
      if (right - left - 1 <= longest_px && right - left - 1 < width) {
        across = cross(end(left, y, x - left), end(right, y, right - x), right - left - 1);
      }
      if (down - up - 1 <= longest_px && down - up - 1 < height) {
        along = cross(end(x, up, y - up), end(x, down, down - y), down - up - 1);
      }
      const Bridge& bridge = better(across, along);
      if (bridge.length_px == 0) continue;
      const auto third = static_cast<std::size_t>((3 * bridge.length_px - 1) / longest_px);
      const float trust = trust_[static_cast<std::size_t>(bridge.kind)][third];
      const float confidence = std::min(trust, bridge.confidence);
      if (confidence <= 0.0F || confidence < settings.least_confidence) continue;
      map.disparity_px(y, x) = bridge.disparity;
      map.confidence(y, x) = confidence;
    }
  }
}

}  // namespace striate::perception
