#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "striate/perception/stereo/row_offset.hpp"
#include "tests/reference/test_images.hpp"
#include "tests/unit/perception/stereo_summary.hpp"

/// Pairs that mislead a matcher: what repeats itself, eyes that are not level, patterns of the
/// sensors.
namespace striate::perception {
namespace {

const cv::Size kPairSize{160, 120};

/// A board before a textured wall, 15 px nearer than it, that shows the same again and again.
std::pair<cv::Mat1b, cv::Mat1b> repeated_pair(bool squares, int period, std::uint64_t seed) {
  constexpr int kBoard_px = 15;
  cv::Mat1b left = reference::texture(kPairSize, 1), right = reference::texture(kPairSize, 1, 2);
  cv::Mat1b board(kPairSize);
  for (int y = 0; y < kPairSize.height; ++y) {
    for (int x = 0; x < kPairSize.width; ++x) {
      const bool dark = (x / (period / 2) + (squares ? y / (period / 2) : 0)) % 2 == 0;
      board(y, x) = dark ? 60 : 190;
    }
  }
  const cv::Rect place(30, 15, 110, 90);
  board(place).copyTo(left(place));
  board(place).copyTo(right(place - cv::Point(kBoard_px, 0)));
  return {reference::with_noise(left, 1.0, seed), reference::with_noise(right, 1.0, seed + 1)};
}

TEST(StereoMatcher, WhatRepeatsItselfIsMostlyUnknownOrRight) {
  double wrong = 0.0;
  int boards = 0;
  for (const bool squares : {false, true}) {
    for (const int period : {4, 8, 12, 16}) {
      const auto [left, right] = repeated_pair(squares, period, 7);
      const DisparityMap map = StereoMatcher({}).match(left, right);
      int missed = 0;
      const cv::Rect inner(46, 18, 90, 84);
      for (int y = inner.y; y < inner.br().y; ++y) {
        for (int x = inner.x; x < inner.br().x; ++x) {
          const float d = map.disparity_px(y, x);
          missed += d != kNoMatch && std::abs(d - 15.0F) > 1.5F;
        }
      }
      wrong += static_cast<double>(missed) / inner.area();
      ++boards;
    }
  }
  EXPECT_LT(wrong / boards, 0.06) << "a quarter before patterns were looked for";
}

cv::Mat1b lower(const cv::Mat1b& image, double rows) {
  cv::Mat1b moved;
  const cv::Matx23d down(1.0, 0.0, 0.0, 0.0, 1.0, rows);
  cv::warpAffine(image, moved, down, image.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
  return moved;
}

TEST(StereoMatcher, RowsThatTheEyesShowAtDifferentHeightsAreMovedAndTold) {
  constexpr int kShift = 9;
  const cv::Mat1b left = reference::texture(kPairSize, 1);
  const cv::Mat1b right = reference::texture(kPairSize, 1, kShift);
  StereoSettings as_they_are;
  as_they_are.robust.align_rows = false;
  for (const double rows : {-2.4, -1.5, 1.1, 2.4}) {
    const cv::Mat1b lowered = lower(right, rows);
    const DisparityMap map = StereoMatcher({}).match(left, lowered);
    const Summary found = summarise(map, kShift, kShift + 12);
    EXPECT_NEAR(map.right_lower_px, rows, 0.15);
    EXPECT_GT(found.known, 0.9) << rows;
    EXPECT_GT(found.right, 0.97) << rows;
    const DisparityMap unmoved = StereoMatcher(as_they_are).match(left, lowered);
    EXPECT_EQ(unmoved.right_lower_px, 0.0);
    EXPECT_LT(summarise(unmoved, kShift, kShift + 12).known, found.known) << rows;
  }
}

TEST(StereoMatcher, RowsThatAgreeAreLeftAsTheyAre) {
  const cv::Mat1b left = reference::texture(kPairSize, 1),
                  right = reference::texture(kPairSize, 1, 9);
  EXPECT_EQ(StereoMatcher({}).match(left, right).right_lower_px, 0.0);
  const cv::Mat1b blank(kPairSize, std::uint8_t{120});
  for (int seed = 1; seed < 30; ++seed) {
    const DisparityMap dark = StereoMatcher({}).match(
        reference::with_noise(blank, 3.0, seed), reference::with_noise(blank, 3.0, seed + 100));
    EXPECT_EQ(dark.right_lower_px, 0.0) << seed;
  }
}

// Fixed pattern noise, dust, blocks of JPEG: the same in both images at the same pixel.
TEST(StereoMatcher, ABlankWallWithAWeakPatternCommonToBothSensorsIsUnknown) {
  StereoMatcher stereo({});
  for (const double pattern : {0.5, 1.0, 2.0}) {
    const cv::Mat1b wall =
        reference::with_noise(cv::Mat1b(kPairSize, std::uint8_t{120}), pattern, 3);
    const DisparityMap map =
        stereo.match(reference::with_noise(wall, 0.3, 1), reference::with_noise(wall, 0.3, 2));
    EXPECT_LT(cv::countNonZero(map.confidence), 0.03 * kPairSize.area()) << pattern;
  }
}

TEST(StereoMatcher, WhatIsInfinitelyFarAndWellSeenIsKnown) {
  const cv::Mat1b far = reference::texture(kPairSize, 5);
  const DisparityMap map = StereoMatcher({}).match(far, far);
  EXPECT_GT(cv::countNonZero(map.confidence), 0.9 * kPairSize.area());
}

// The cubic goes beyond white beside an edge; V1 counts on twelve bits.
TEST(StereoMatcher, MovedRowsOfFineGreysStayWithinWhite) {
  constexpr std::uint16_t kWhite = 4080;  // 255 in sixteenths
  cv::Mat1w image(kPairSize, kWhite);
  image.rowRange(40, 60).setTo(0);
  double least = 0.0, most = 0.0;
  cv::minMaxLoc(raised(image, 0.5), &least, &most);
  EXPECT_EQ(least, 0.0);
  EXPECT_EQ(most, kWhite);
}

}  // namespace
}  // namespace striate::perception
