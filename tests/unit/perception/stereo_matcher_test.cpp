#include "striate/perception/stereo/stereo_matcher.hpp"

#include <gtest/gtest.h>

#include "striate/base/user_error.hpp"
#include "striate/perception/stereo/decision.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/test_images.hpp"
#include "tests/unit/perception/stereo_summary.hpp"

namespace striate::perception {
namespace {

const cv::Size kSize{160, 120};

StereoMatcher matcher(StereoMode mode) {
  StereoSettings settings;
  settings.mode = mode;
  return StereoMatcher(settings);
}

TEST(StereoMatcher, FindsTheShiftOfAShiftedTexture) {
  for (const StereoMode mode : {StereoMode::paper, StereoMode::robust}) {
    StereoMatcher stereo = matcher(mode);
    for (const int shift : {0, 1, 7, 30, 60}) {
      // What is at x in the left image is at x - shift in the right one.
      const Summary found =
          summarise(stereo.match(reference::texture(kSize, 1), reference::texture(kSize, 1, shift)),
                    shift, shift + 12);
      EXPECT_GT(found.known, 0.97) << shift;
      EXPECT_GT(found.right, 0.99) << shift;
    }
  }
}

TEST(StereoMatcher, RobustFindsHalfPixels) {
  // Both images are means over two pixels of one drawn at twice the width.
  const cv::Mat1b fine = reference::texture({2 * kSize.width + 32, kSize.height}, 2);
  auto eye = [&](int shift) {
    cv::Mat1b image(kSize);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        const int u = 2 * x + shift;
        image(y, x) = static_cast<std::uint8_t>((fine(y, u) + fine(y, u + 1) + 1) / 2);
      }
    }
    return image;
  };
  const DisparityMap map = matcher(StereoMode::robust).match(eye(0), eye(15));
  double sum = 0.0;
  int count = 0;
  for (int y = 10; y < 110; ++y) {
    for (int x = 30; x < 150; ++x) {
      if (map.disparity_px(y, x) == kNoMatch) continue;
      sum += std::abs(map.disparity_px(y, x) - 7.5F);
      ++count;
    }
  }
  ASSERT_GT(count, 10000);
  EXPECT_LT(sum / count, 0.3) << "whole pixels would be 0.5 off";
}

TEST(StereoMatcher, ABlankImageIsUnknownNotANumber) {
  StereoMatcher stereo = matcher(StereoMode::robust);
  for (const int grey : {0, 130, 255}) {
    const cv::Mat1b blank(kSize, static_cast<std::uint8_t>(grey));
    const DisparityMap map = stereo.match(blank, blank);
    EXPECT_EQ(summarise(map, 0.0, 70).known, 0.0) << grey;
    EXPECT_EQ(cv::countNonZero(map.confidence), 0) << grey;
  }
}

TEST(StereoMatcher, ABlankWallWithNoiseIsNeverSeenNearWithConfidence) {
  for (const StereoConfidence measure : {StereoConfidence::score, StereoConfidence::promise}) {
    StereoSettings settings;
    settings.robust.confidence = measure;
    StereoMatcher stereo(settings);
    // As a promise a score of 0.5 is 0.76: of scenes with things in them so many are right.
    const float sure = measure == StereoConfidence::score ? 0.5F : promise_of(0.5F);
    for (const double sigma : {1.0, 3.0, 8.0}) {
      const cv::Mat1b blank(kSize, std::uint8_t{120});
      const DisparityMap map = stereo.match(reference::with_noise(blank, sigma, 1),
                                            reference::with_noise(blank, sigma, 2));
      int claimed = 0;
      for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
          claimed += map.confidence(y, x) > sure && map.disparity_px(y, x) > 10.0F;
        }
      }
      EXPECT_LT(claimed, 0.005 * kSize.area()) << sigma;
      EXPECT_LT(cv::countNonZero(map.confidence), 0.1 * kSize.area()) << sigma;
    }
  }
}

TEST(StereoMatcher, WhatOnlyTheLeftEyeSeesIsMostlyUnknown) {
  // A square 24 px in front of a background at 4 px hides a strip of the background.
  constexpr int kNear = 24, kFar = 4;
  const cv::Rect square(70, 30, 50, 60);
  cv::Mat1b left = reference::texture(kSize, 3), right = reference::texture(kSize, 3, kFar);
  const cv::Mat1b front = reference::texture(square.size(), 4);
  front.copyTo(left(square));
  front.copyTo(right(square - cv::Point(kNear, 0)));
  const DisparityMap map = matcher(StereoMode::robust).match(left, right);
  int hidden_known = 0, front_right = 0;
  for (int y = square.y + 4; y < square.br().y - 4; ++y) {
    // Background at x is hidden where x - kFar falls onto the square seen by the right eye.
    for (int x = square.x - kNear + kFar; x < square.x; ++x) {
      hidden_known += map.disparity_px(y, x) != kNoMatch;
    }
    for (int x = square.x + 3; x < square.br().x - 3; ++x) {
      front_right += std::abs(map.disparity_px(y, x) - kNear) <= 0.5F;
    }
  }
  EXPECT_LT(hidden_known, 0.35 * 52 * (kNear - kFar));
  EXPECT_GT(front_right, 0.95 * 52 * 44);
}

TEST(StereoMatcher, NoiseLowersConfidence) {
  StereoMatcher stereo = matcher(StereoMode::robust);
  const cv::Mat1b left = reference::texture(kSize, 1, 0, 40);
  const cv::Mat1b right = reference::texture(kSize, 1, 9, 40);
  double before = 1.1;
  for (const double sigma : {0.0, 6.0, 12.0, 24.0}) {
    const Summary found = summarise(
        stereo.match(reference::with_noise(left, sigma, 1), reference::with_noise(right, sigma, 2)),
        9.0, 30);
    EXPECT_LT(found.confidence, before - 0.005) << sigma;
    before = found.confidence;
  }
}

TEST(StereoMatcher, ConfidenceKeepsItsPromiseInNoise) {
  StereoMatcher stereo = matcher(StereoMode::robust);
  const DisparityMap map =
      stereo.match(reference::with_noise(reference::texture(kSize, 1, 0, 50), 14.0, 1),
                   reference::with_noise(reference::texture(kSize, 1, 9, 50), 14.0, 2));
  int sure = 0, right = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 20; x < kSize.width; ++x) {
      if (map.confidence(y, x) < 0.8F) continue;
      ++sure;
      right += std::abs(map.disparity_px(y, x) - 9.0F) <= 1.25F;
    }
  }
  ASSERT_GT(sure, 1000);
  EXPECT_GT(right, 0.8 * sure);
}

TEST(StereoMatcher, ARepetitiveTextureIsLessCertainThanAUniqueOne) {
  StereoMatcher stereo = matcher(StereoMode::robust);
  cv::Mat1b stripes(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      stripes(y, x) = static_cast<std::uint8_t>(x % 8 < 4 ? 90 : 160);
    }
  }
  const Summary repeated = summarise(stereo.match(stripes, stripes), 0.0, 70);
  const Summary unique =
      summarise(stereo.match(reference::texture(kSize, 1), reference::texture(kSize, 1)), 0.0, 70);
  EXPECT_LT(repeated.confidence, 0.8 * unique.confidence);
}

TEST(StereoMatcher, GivesTheSameBitsOnEveryInstructionSet) {
  const cv::Mat1b left = reference::with_noise(reference::texture({131, 47}, 1), 5.0, 1);
  const cv::Mat1b right = reference::with_noise(reference::texture({131, 47}, 1, 6), 5.0, 2);
  for (const StereoMode mode : {StereoMode::paper, StereoMode::robust}) {
    StereoMatcher stereo = matcher(mode);
    DisparityMap first;
    reference::on_every_target([&](const std::string& name) {
      const DisparityMap map = stereo.match(left, right);
      if (first.disparity_px.empty()) first = map;
      for (int y = 0; y < left.rows; ++y) {
        for (int x = 0; x < left.cols; ++x) {
          ASSERT_EQ(map.disparity_px(y, x), first.disparity_px(y, x)) << name;
          ASSERT_EQ(map.confidence(y, x), first.confidence(y, x)) << name;
        }
      }
    });
  }
}

TEST(StereoMatcher, GivesTheSameForTheSecondPairAsForTheFirst) {
  StereoMatcher stereo = matcher(StereoMode::robust);
  const cv::Mat1b left = reference::texture({90, 50}, 1),
                  right = reference::texture({90, 50}, 1, 5);
  const DisparityMap first = stereo.match(left, right);
  (void)stereo.match(reference::texture({160, 70}, 7), reference::texture({160, 70}, 8));
  const DisparityMap again = stereo.match(left, right);
  EXPECT_EQ(cv::countNonZero(first.disparity_px != again.disparity_px), 0);
  EXPECT_EQ(cv::countNonZero(first.confidence != again.confidence), 0);
}

TEST(StereoMatcher, UsesTheMatricesOfTheResultAgain) {
  StereoMatcher stereo = matcher(StereoMode::robust);
  const cv::Mat1b left = reference::texture({90, 50}, 1);
  DisparityMap map;
  stereo.match(left, left, map);
  const auto* data = map.disparity_px.data;
  stereo.match(left, left, map);
  EXPECT_EQ(map.disparity_px.data, data);
}

TEST(StereoMatcher, TakesImagesOfAnySize) {
  for (const StereoMode mode : {StereoMode::paper, StereoMode::robust}) {
    StereoMatcher stereo = matcher(mode);
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(2, 9), cv::Size(17, 1), cv::Size(63, 65),
                                cv::Size(64, 64), cv::Size(321, 13)}) {
      const DisparityMap map =
          stereo.match(reference::texture(size, 1), reference::texture(size, 1));
      EXPECT_EQ(map.disparity_px.size(), size);
      EXPECT_EQ(map.confidence.size(), size);
    }
  }
}

TEST(StereoMatcher, TakesAnyNumberOfCandidates) {
  const cv::Mat1b left = reference::texture({120, 20}, 1),
                  right = reference::texture({120, 20}, 1, 3);
  for (const StereoMode mode : {StereoMode::paper, StereoMode::robust}) {
    for (const int candidates : {1, 2, 5, 255, 256}) {
      StereoSettings settings;
      settings.mode = mode;
      settings.candidates = candidates;
      settings.robust.speckle_px = 0;
      const DisparityMap map = StereoMatcher(settings).match(left, right);
      for (const float disparity : cv::Mat1f(map.disparity_px)) {
        EXPECT_TRUE(disparity == kNoMatch || (disparity >= 0.0F && disparity < candidates));
      }
    }
  }
}

TEST(StereoMatcher, SaysWhatIsWrongWithItsImages) {
  StereoMatcher stereo = matcher(StereoMode::robust);
  const cv::Mat1b small(10, 20, std::uint8_t{0}), large(10, 21, std::uint8_t{0});
  EXPECT_THROW((void)stereo.match(cv::Mat1b(), cv::Mat1b()), std::invalid_argument);
  try {
    (void)stereo.match(small, large);
    FAIL() << "different sizes were taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("20x10"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("21x10"), std::string::npos) << error.what();
  }
}

TEST(StereoMatcher, RefusesSettingsOutOfRange) {
  StereoSettings settings;
  settings.candidates = 257;
  EXPECT_THROW(StereoMatcher{settings}, UserError);
  settings.candidates = 0;
  settings.robust.large_step_penalty = 500;
  EXPECT_THROW(StereoMatcher{settings}, UserError);
}

TEST(StereoScore, FallsWithWhatSmoothnessPaidAndGrowsWithTexture) {
  for (const StereoConfidence measure : {StereoConfidence::score, StereoConfidence::promise}) {
    auto confidence = [&](const StereoEvidence& e) { return stereo_confidence(e, measure); };
    EXPECT_GT(confidence({200, 500, 30, 60, 20000}), confidence({200, 900, 30, 60, 20000}));
    EXPECT_GT(confidence({200, 600, 30, 60, 40000}), confidence({200, 600, 30, 60, 10000}));
  }
}

TEST(StereoScore, IsLowWhereAnotherDisparityIsAsGood) {
  EXPECT_EQ(stereo_confidence({0, 0, 0, 0, 0}, StereoConfidence::score), 0.0F);
  EXPECT_EQ(stereo_confidence({0, 0, 0, 0, 0}, StereoConfidence::promise), 0.0F);
  EXPECT_LT(stereo_confidence({200, 0, 0, 0, 40000}, StereoConfidence::score), 0.5F);
  EXPECT_EQ(stereo_confidence({200, 0, 0, 0, 40000}, StereoConfidence::promise),
            promise_of(stereo_confidence({200, 0, 0, 0, 40000}, StereoConfidence::score)));
}

}  // namespace
}  // namespace striate::perception
