#pragma once

#include <cmath>

#include "striate/perception/stereo/stereo_matcher.hpp"

/// How much of a match is known and right, where one disparity is expected.
namespace striate::perception {

struct Summary {
  double known = 0.0;       ///< share of the judged pixels that have a disparity
  double right = 0.0;       ///< share of those that are within 0.5 px of what is expected
  double confidence = 0.0;  ///< mean over all judged pixels, unknown ones count as 0
};

/// Judges columns from `from_x` on, away from the image's border.
inline Summary summarise(const DisparityMap& map, double expected_px, int from_x) {
  Summary result;
  int judged = 0, known = 0, right = 0;
  for (int y = 8; y < map.disparity_px.rows - 8; ++y) {
    for (int x = from_x; x < map.disparity_px.cols - 8; ++x) {
      ++judged;
      result.confidence += map.confidence(y, x);
      if (map.disparity_px(y, x) == kNoMatch) continue;
      ++known;
      right += std::abs(map.disparity_px(y, x) - expected_px) <= 0.5;
    }
  }
  result.known = static_cast<double>(known) / judged;
  result.right = known == 0 ? 0.0 : static_cast<double>(right) / known;
  result.confidence /= judged;
  return result;
}

}  // namespace striate::perception
