#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "striate/perception/stereo/decision.hpp"
#include "striate/perception/stereo/gap_filling.hpp"

namespace striate::perception {
namespace {

constexpr int kGapsWidth = 40, kGapsHeight = 30;

/// A wall at 5 px, of confidence 0.9.
DisparityMap wall() {
  DisparityMap map;
  map.disparity_px = cv::Mat1f(kGapsHeight, kGapsWidth, 5.0F);
  map.confidence = cv::Mat1f(kGapsHeight, kGapsWidth, 0.9F);
  return map;
}

void forget(DisparityMap& map, const cv::Rect& part) {
  map.disparity_px(part).setTo(kNoMatch);
  map.confidence(part).setTo(0.0F);
}

TEST(GapFilling, BridgesASmallGapOfOneSurfaceByAStraightLine) {
  DisparityMap map = wall();
  for (int x = 0; x < kGapsWidth; ++x) {
    map.disparity_px.col(x).setTo(5.0F + 0.25F * static_cast<float>(x));
  }
  forget(map, {10, 4, 4, 20});
  GapFilling().fill({8}, map);
  for (int x = 10; x < 14; ++x) {
    EXPECT_FLOAT_EQ(map.disparity_px(12, x), 5.0F + 0.25F * static_cast<float>(x));
    EXPECT_FLOAT_EQ(map.confidence(12, x), kGapTrust[0][1]);
  }
}

TEST(GapFilling, IsNoSurerThanTheEnds) {
  DisparityMap map = wall();
  map.confidence.setTo(0.4F);
  forget(map, {10, 4, 2, 20});
  GapFilling().fill({8}, map);
  EXPECT_FLOAT_EQ(map.confidence(12, 10), 0.4F);
}

TEST(GapFilling, LeavesLargeGapsUnknown) {
  DisparityMap map = wall();
  forget(map, {10, 4, 9, 9});
  GapFilling().fill({8}, map);
  EXPECT_EQ(cv::countNonZero(map.disparity_px == kNoMatch), 81);
  GapFilling().fill({9}, map);
  EXPECT_EQ(cv::countNonZero(map.disparity_px == kNoMatch), 0);
}

TEST(GapFilling, LetsTheFartherSurfaceGoOnBehindTheNearerOne) {
  DisparityMap map = wall();
  map.disparity_px.colRange(20, kGapsWidth).setTo(15.0F);
  forget(map, {16, 0, 4, kGapsHeight});
  GapFilling().fill({8}, map);
  EXPECT_FLOAT_EQ(map.disparity_px(12, 17), 5.0F);
  EXPECT_FLOAT_EQ(map.confidence(12, 17), kGapTrust[1][1]);
}

TEST(GapFilling, TakesTheOnlyEndOfAGapAtTheBorder) {
  DisparityMap map = wall();
  forget(map, {kGapsWidth - 2, 0, 2, kGapsHeight});
  GapFilling().fill({8}, map);
  EXPECT_FLOAT_EQ(map.disparity_px(12, kGapsWidth - 1), 5.0F);
  EXPECT_FLOAT_EQ(map.confidence(12, kGapsWidth - 1), kGapTrust[2][0]);
}

TEST(GapFilling, FillsNothingOfLessThanTheLeastConfidence) {
  DisparityMap map = wall();
  forget(map, {10, 4, 4, 20});
  GapFilling().fill({8, kGapTrust[0][1] + 0.01F}, map);
  EXPECT_EQ(map.disparity_px(12, 11), kNoMatch);
  EXPECT_EQ(map.confidence(12, 11), 0.0F);
}

TEST(GapFilling, InventsNothingWhereNothingIsKnown) {
  DisparityMap map = wall();
  forget(map, {0, 0, kGapsWidth, kGapsHeight});
  GapFilling().fill({100}, map);
  EXPECT_EQ(cv::countNonZero(map.disparity_px == kNoMatch), kGapsWidth * kGapsHeight);
}

TEST(StereoPromise, GrowsWithTheScoreAndStaysAShare) {
  float before = 0.0F;
  for (int k = 0; k <= 1000; ++k) {
    const float promise = promise_of(static_cast<float>(k) / 1000.0F);
    EXPECT_GE(promise, before) << k;
    EXPECT_LE(promise, 1.0F);
    before = promise;
  }
}

}  // namespace
}  // namespace striate::perception
