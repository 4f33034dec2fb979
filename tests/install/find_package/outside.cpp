#include <cmath>
#include <cstdint>
#include <cstdio>
#include <opencv2/core.hpp>

#include "striate/perception/stereo/stereo_matcher.hpp"

/// What a user of the installed library writes: an image pair of a wall 9 px of disparity away, and
/// how many of its disparities the robust stereo gets right. Returns 0 if nearly all of them.
int main() {
  constexpr int kWidth_px = 160, kHeight_px = 120, kWall_px = 9;
  cv::Mat1b texture(kHeight_px, kWidth_px + kWall_px);
  std::uint32_t state = 1;
  for (std::uint8_t& grey : texture) {
    state = state * 1664525U + 1013904223U;  // Numerical Recipes' generator
    grey = static_cast<std::uint8_t>(state >> 24);
  }
  // What stands at u in the left image stands at u - 9 in the right one.
  const cv::Mat1b left = texture.colRange(0, kWidth_px).clone();
  const cv::Mat1b right = texture.colRange(kWall_px, kWidth_px + kWall_px).clone();

  striate::perception::StereoMatcher matcher{striate::perception::StereoSettings{}};
  const striate::perception::DisparityMap map = matcher.match(left, right);
  int known = 0, correct = 0;
  for (const float disparity_px : map.disparity_px) {
    if (disparity_px == striate::perception::kNoMatch) continue;
    ++known;
    if (std::abs(disparity_px - kWall_px) < 0.5F) ++correct;
  }
  std::printf("%d x %d: %d %% known, %d %% of them right\n", map.disparity_px.cols,
              map.disparity_px.rows, 100 * known / (kWidth_px * kHeight_px),
              known ? 100 * correct / known : 0);
  return known > kWidth_px * kHeight_px * 8 / 10 && correct > known * 95 / 100 ? 0 : 1;
}
