#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "striate/perception/recognition/evidence.hpp"
#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "striate/perception/recognition/recogniser.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::perception {
namespace {

cv::Mat1b coarse_texture(cv::Size size, int seed) {
  cv::Mat1b fine = reference::texture({size.width / 3, size.height / 3}, seed), coarse;
  cv::resize(fine, coarse, size, 0, 0, cv::INTER_CUBIC);
  return coarse;
}

/// Boxes of one brand: the upper half of all is the same, the lower half is this one's own.
cv::Mat1b box_of_a_brand(int own) {
  cv::Mat1b box(240, 180);
  coarse_texture({180, 120}, 500).copyTo(box.rowRange(0, 120));
  coarse_texture({180, 120}, own).copyTo(box.rowRange(120, 240));
  return box;
}

std::vector<Keypoint> points_of(const cv::Mat1b& grey) {
  return OrientedKeypoints(OrientedSettings{})(grey);
}

LandmarkView view_of(const cv::Mat1b& picture) {
  return make_view(picture, {0, 0, picture.cols, picture.rows}, points_of);
}

Recogniser knows(std::initializer_list<cv::Mat1b> pictures) {
  Recogniser recogniser{RecognitionSettings{}};
  int landmark = 0;
  for (const cv::Mat1b& picture : pictures) recogniser.add(landmark++, view_of(picture));
  return recogniser;
}

/// On a wall of another texture, at (u, v), made larger.
cv::Mat1b scene_of(const cv::Mat1b& thing, double scale, int u_px, int v_px) {
  cv::Mat1b scene = coarse_texture({639, 480}, 900), larger;
  cv::resize(thing, larger, {}, scale, scale, cv::INTER_AREA);
  larger.copyTo(scene(cv::Rect({u_px, v_px}, larger.size())));
  return reference::with_noise(scene, 3.0, 7);
}

TEST(AlikeThings, AreToldApartByWhatOnlyOneHas) {
  Recogniser recogniser = knows({box_of_a_brand(61), box_of_a_brand(62), box_of_a_brand(63)});
  for (const int which : {0, 1, 2}) {
    const auto& found =
        recogniser.recognise(points_of(scene_of(box_of_a_brand(61 + which), 0.9, 200, 100)));
    ASSERT_EQ(found.size(), 1U) << which;
    EXPECT_EQ(found[0].landmark, which);
    EXPECT_NEAR(found[0].v_px, 100 + 0.9 * 120, 5) << "the whole box, not the part it goes by";
  }
}

TEST(AlikeThings, OneThatWasNotTaughtIsNotTakenForThoseThatWere) {
  Recogniser recogniser = knows({box_of_a_brand(61), box_of_a_brand(62), box_of_a_brand(63)});
  for (const int other : {64, 65, 66}) {
    EXPECT_TRUE(
        recogniser.recognise(points_of(scene_of(box_of_a_brand(other), 1.0, 150, 120))).empty())
        << other;
  }
}

TEST(AlikeThings, BothAreFoundWhereBothStand) {
  Recogniser recogniser = knows({box_of_a_brand(61), box_of_a_brand(62)});
  cv::Mat1b scene = scene_of(box_of_a_brand(61), 1.0, 60, 100);
  box_of_a_brand(62).copyTo(scene(cv::Rect(360, 150, 180, 240)));
  EXPECT_EQ(recogniser.recognise(points_of(scene)).size(), 2U);
}

TEST(AlikeThings, AThingThatWasTaughtUnderTwoNamesIsFoundUnderOne) {
  Recogniser recogniser =
      knows({box_of_a_brand(61), reference::with_noise(box_of_a_brand(61), 5.0, 3)});
  EXPECT_EQ(recogniser.recognise(points_of(scene_of(box_of_a_brand(61), 0.9, 200, 100))).size(),
            1U);
}

TEST(AlikeThings, WhatIsSharedIsFoundOutAgainWhenViewsComeAndGo) {
  Recogniser recogniser = knows({box_of_a_brand(61)});
  const std::vector<Keypoint> other = points_of(scene_of(box_of_a_brand(64), 1.0, 150, 120));
  EXPECT_EQ(recogniser.recognise(other).size(), 1U) << "a lone box goes by its label, too";
  const int second = recogniser.add(1, view_of(box_of_a_brand(62)));
  EXPECT_TRUE(recogniser.recognise(other).empty());
  recogniser.remove(second);
  EXPECT_EQ(recogniser.recognise(other).size(), 1U);
}

TEST(AlikeThings, InAVeryLargeMemoryAreToldApartInALaterLookSoThatNoneTakesLong) {
  Recogniser recogniser = knows({box_of_a_brand(61), box_of_a_brand(62)});
  const LandmarkView other = view_of(coarse_texture({48, 48}, 7));
  for (int k = 0; k < 450; ++k) recogniser.add(2 + k, other);
  const std::vector<Keypoint> scene = points_of(scene_of(box_of_a_brand(61), 0.9, 200, 100));
  const std::vector<int> order{0};
  EXPECT_TRUE(recogniser.recognise(scene, order, {}).empty()) << "450 are not compared in a look";
  ASSERT_EQ(recogniser.recognise(scene, order, {}).size(), 1U);
  recogniser.add(500, other);
  EXPECT_TRUE(recogniser.recognise(scene, order, {}).empty()) << "it may share a part, too";
}

TEST(AlikeThings, ALabelOnAnotherThingIsNotSpreadOverTheView) {
  RecognitionSettings settings;
  settings.least_spread = 0.35;
  const cv::Mat1b box = coarse_texture({180, 240}, 71);
  cv::Mat1b other = coarse_texture({180, 240}, 72);
  box(cv::Rect(50, 90, 80, 80)).copyTo(other(cv::Rect(20, 20, 80, 80)));
  Recogniser any(RecognitionSettings{}), spread_out(settings);
  for (Recogniser* one : {&any, &spread_out}) one->add(0, view_of(box));
  const std::vector<Keypoint> points = points_of(scene_of(other, 1.3, 100, 60));
  EXPECT_EQ(any.recognise(points).size(), 1U) << "else the label is too small to show anything";
  EXPECT_TRUE(spread_out.recognise(points).empty());
  EXPECT_EQ(spread_out.recognise(points_of(scene_of(box, 0.8, 100, 60))).size(), 1U);
}

TEST(Evidence, ChanceGrowsWithThePairsAndShrinksWithThoseThatAgree) {
  const auto chance = [](int pairs, int agree, double residual) {
    return log10_chance({pairs, 0.5, 0.3}, std::vector<double>(agree, residual));
  };
  EXPECT_LT(chance(100, 12, 0.02), chance(400, 12, 0.02));
  EXPECT_LT(chance(100, 12, 0.02), chance(100, 9, 0.02));
  EXPECT_LT(chance(100, 12, 0.015), chance(100, 12, 0.03));
  EXPECT_LE(chance(100, 12, 0.02), chance(100, 8, 0.02)) << "the best number of pairs counts";
  EXPECT_TRUE(std::isinf(chance(100, 3, 0.0))) << "three carry any pose";
}

TEST(Evidence, AKeypointThatIsListedTwiceCountsOnce) {
  const auto pair = [](int view_point, double view_u_px, double image_u_px) {
    return PlacePair{{view_u_px, 10.0, 4.0, 0.0}, {image_u_px, 10.0, 4.0, 0.0}, view_point};
  };
  const std::vector<PlacePair> once{pair(0, 10.0, 10.0), pair(1, 30.0, 31.0)};
  std::vector<PlacePair> again = once;
  again.push_back(pair(1, 30.0, 29.5));  // the same of the view, another of the image
  again.push_back(pair(2, 29.0, 31.2));  // another of the view, the same pixel of the image
  std::vector<double> of_once, of_again;
  residuals_of(once, Pose{}, 100.0, of_once);
  residuals_of(again, Pose{}, 100.0, of_again);
  EXPECT_EQ(of_once, (std::vector<double>{0.0, 0.01}));
  EXPECT_EQ(of_again, of_once);
}

TEST(Evidence, PairsThatAreDrawnAtRandomAreRarelyBelowWhatIsExpected) {
  std::mt19937 random(5);
  const auto uniform = [&] { return random() / 4294967296.0; };
  ConsensusFinder consensus{RecognitionSettings{}};
  std::vector<double> residuals;
  int below = 0;
  constexpr int kTries = 400;
  for (int k = 0; k < kTries; ++k) {
    std::vector<PlacePair> pairs;
    for (int i = 0; i < 120; ++i) {
      const auto place = [&](double side) {
        return KeypointFrame{side * uniform(), side * uniform(), 4.0 + 8.0 * uniform(),
                             6.28 * uniform()};
      };
      pairs.push_back({place(200.0), place(400.0), i});
    }
    const Consensus found = consensus.find(pairs, 200.0, 200.0);
    if (found.inliers < 4) continue;
    residuals_of(consensus.agreeing(), found.pose, 200.0, residuals);
    const PairsUnderPose all = pairs_under(pairs, found.pose, 200.0, 200.0);
    below += log10_chance(all, residuals) < -1.0 ? 1 : 0;
  }
  EXPECT_LE(below, kTries / 10) << "one in ten looks, if the bound is one";
}

TEST(Evidence, AScoreTellsHowRareAChanceIs) {
  EXPECT_DOUBLE_EQ(score_of_chance(-3.0, 0.001), 0.5);
  EXPECT_DOUBLE_EQ(score_of_chance(-13.0, 0.001), 0.75);
  EXPECT_DOUBLE_EQ(score_of_chance(std::numeric_limits<double>::infinity(), 0.001), 0.0);
  for (const double log10_expected : {-300.0, -20.0, -3.0, 0.0, 5.0}) {
    EXPECT_NEAR(log10_expected_of(score_of_chance(log10_expected, 0.001), 0.001), log10_expected,
                1e-9 * std::abs(log10_expected) + 1e-9);
  }
}

}  // namespace
}  // namespace striate::perception
