#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/perception/visual_odometry/feature_matching.hpp"
#include "striate/perception/visual_odometry/stereo_points.hpp"
#include "striate/perception/visual_odometry/striate_features.hpp"
#include "tests/reference/rendered_room.hpp"

namespace striate::perception {
namespace {

using testing::ElementsAre;

const cv::Size kFeatureView(320, 240);

/// Features at these places, each with a descriptor of its own kind: `kind` bits are set.
FeatureSet features_at(const std::vector<std::pair<cv::Point2d, int>>& places) {
  FeatureSet set;
  set.most_distance = 20.0;
  for (const auto& [at, kind] : places) {
    set.features.push_back({at.x, at.y, 1.0, 1.0});
    for (int byte = 0; byte < set.bytes; ++byte) {
      set.descriptors.push_back(byte / 4 == kind ? 255 : 0);
    }
  }
  return set;
}

std::vector<std::pair<std::size_t, std::size_t>> numbers_of(const std::vector<FeaturePair>& pairs) {
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  for (const FeaturePair& pair : pairs) numbers.emplace_back(pair.from, pair.to);
  return numbers;
}

TEST(SpreadFeatures, EachPartOfTheImageKeepsItsStrongest) {
  std::vector<Feature> features;
  for (int k = 0; k < 50; ++k) features.push_back({10.0, 10.0, 1.0, 100.0 + k});  // one cell
  features.push_back({300.0, 10.0, 1.0, 1.0});
  features.push_back({10.0, 230.0, 1.0, 2.0});
  EXPECT_THAT(spread_evenly(features, kFeatureView, 3), ElementsAre(49, 50, 51));
  EXPECT_THAT(spread_evenly(features, kFeatureView, 5), ElementsAre(47, 48, 49, 50, 51));
  EXPECT_EQ(spread_evenly(features, kFeatureView, 60).size(), 52U);
  EXPECT_TRUE(spread_evenly(features, kFeatureView, 0).empty());
  EXPECT_TRUE(spread_evenly({}, kFeatureView, 10).empty());
}

TEST(MatchEyes, FindsTheSameOnTheRowWithinTheDisparitiesThatAreAllowed) {
  const FeatureSet left = features_at({{{100, 50}, 0}, {{200, 80}, 1}, {{150, 120}, 2}});
  const FeatureSet right = features_at({{{90, 51}, 0},      // ten pixels to the left, on its row
                                        {{190, 90}, 1},     // not on the row
                                        {{160, 120}, 2}});  // behind infinity
  const FeatureGrid grid(right, kFeatureView);
  EXPECT_THAT(numbers_of(match_eyes(left, right, grid, kFeatureView, 0.0, {})),
              ElementsAre(std::pair(0U, 0U)));
  // Where the right principal point lies 15 px farther right, infinity does, too.
  EXPECT_THAT(numbers_of(match_eyes(left, right, grid, kFeatureView, 15.0, {})),
              ElementsAre(std::pair(0U, 0U), std::pair(2U, 2U)));
}

TEST(MatchEyes, WhatTwoPlacesAreEquallyLikeIsNoPair) {
  const FeatureSet left = features_at({{{100, 50}, 0}});
  FeatureSet right = features_at({{{90, 50}, 0}, {{80, 50}, 0}});
  EXPECT_TRUE(
      match_eyes(left, right, FeatureGrid(right, kFeatureView), kFeatureView, 0.0, {}).empty())
      << "two that are the same bit for bit";
  right.descriptors[31] = 1;  // a bit each is another
  right.descriptors[63] = 2;
  EXPECT_TRUE(
      match_eyes(left, right, FeatureGrid(right, kFeatureView), kFeatureView, 0.0, {}).empty());
}

TEST(MatchNear, FindsTheSameWithinTheRadiusOfWhereItIsLookedForAlone) {
  const FeatureSet then = features_at({{{100, 50}, 0}, {{200, 80}, 1}});
  const FeatureSet now = features_at({{{118, 50}, 0}, {{201, 82}, 1}});
  const FeatureGrid grid(now, kFeatureView);
  EXPECT_THAT(
      numbers_of(match_near(then, {{0, 100.0, 50.0}, {1, 200.0, 80.0}}, now, grid, 10.0, {})),
      ElementsAre(std::pair(1U, 1U)));
  EXPECT_THAT(
      numbers_of(match_near(then, {{0, 115.0, 50.0}, {1, 200.0, 80.0}}, now, grid, 10.0, {})),
      ElementsAre(std::pair(0U, 0U), std::pair(1U, 1U)));
}

TEST(ContrastOfFeatures, NoiseAloneIsNone) {
  reference::RenderedRoom room;
  StereoLook textured, noisy;
  look_with_both(room.see({}, kFeatureView), striate_features(), {}, textured);
  EXPECT_GT(count_with_contrast(textured), 200);
  room.contrast = 0.0;
  room.boxes.clear();
  room.noise = 3.0;
  look_with_both(room.see({}, kFeatureView), striate_features(), {}, noisy);
  EXPECT_LT(count_with_contrast(noisy), 20);
}

}  // namespace
}  // namespace striate::perception
