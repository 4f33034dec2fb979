#include "striate/evaluation/learning/synthetic_stereo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "striate/perception/stereo/stereo_matcher.hpp"

namespace striate::evaluation {
namespace {

const cv::Size kSize{160, 120};
constexpr std::uint64_t kNotFitted = 100000;  ///< seeds from here on: scenes of no fit

TEST(SyntheticStereo, TheSameSeedIsTheSamePair) {
  const SyntheticPair a = synthetic_stereo(kSize, 5), b = synthetic_stereo(kSize, 5);
  EXPECT_EQ(cv::countNonZero(a.left != b.left), 0);
  EXPECT_EQ(cv::countNonZero(a.right != b.right), 0);
  EXPECT_GT(cv::countNonZero(a.left != synthetic_stereo(kSize, 6).left), 1000);
}

TEST(SyntheticStereo, TheTruthBringsTheEyesTogether) {
  // Even seeds: the eyes differ little.
  const SyntheticPair pair = synthetic_stereo(kSize, kNotFitted);
  double aligned = 0.0, not_aligned = 0.0;
  int judged = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (!std::isfinite(pair.truth_px(y, x))) continue;
      const int there = std::max(0, cvRound(static_cast<float>(x) - pair.truth_px(y, x)));
      aligned += std::abs(pair.left(y, x) - pair.right(y, there));
      not_aligned += std::abs(pair.left(y, x) - pair.right(y, x));
      ++judged;
    }
  }
  EXPECT_GT(judged, kSize.area() / 2);
  EXPECT_LT(aligned, 0.5 * not_aligned);
}

TEST(SyntheticStereo, OfWhatIsSaidToBeRightWithNinetyPercentAboutNinetyAre) {
  perception::StereoMatcher stereo{perception::StereoSettings{}};
  int said = 0, right = 0;
  for (std::uint64_t seed = kNotFitted; seed < kNotFitted + 6; ++seed) {
    const SyntheticPair pair = synthetic_stereo(kSize, seed);
    const perception::DisparityMap map = stereo.match(pair.left, pair.right);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        if (!std::isfinite(pair.truth_px(y, x)) || std::abs(map.confidence(y, x) - 0.9F) > 0.03F) {
          continue;
        }
        ++said;
        right += std::abs(map.disparity_px(y, x) - pair.truth_px(y, x)) <= 1.0F;
      }
    }
  }
  ASSERT_GT(said, 2000);
  EXPECT_GT(right, 0.84 * said);
  EXPECT_LT(right, 0.95 * said);
}

}  // namespace
}  // namespace striate::evaluation
