#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "striate/perception/recognition/landmark_finder.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::perception {
namespace {

constexpr double kDisparity_px = 12.0;  // at the working size: 2.03 m along the line of sight

/// A thing with a print of coarse grains, another for each seed.
cv::Mat1b thing(int seed) {
  cv::Mat1b coarse;
  cv::resize(reference::texture({40, 30}, seed), coarse, {120, 90}, 0, 0, cv::INTER_CUBIC);
  return coarse;
}

LandmarkView view_of(int seed) {
  OrientedKeypoints oriented(OrientedSettings{});
  return make_view(thing(seed), {0, 0, 120, 90},
                   [&](const cv::Mat1b& grey) { return oriented(grey); });
}

/// Things hang on a blank wall 2 m ahead of a camera that looks straight on.
struct Scene {
  cv::Mat1b grey = cv::Mat1b(480, 640, std::uint8_t{120});
  Percept percept;

  Scene() {
    percept.light_level = 0.5;
    percept.disparity.focal_px = 203.0;
    percept.disparity.centre_u_px = 79.5;
    percept.disparity.centre_v_px = 59.5;
    percept.disparity.baseline_m = 0.12;
    percept.disparity.disparity_px = cv::Mat1f(120, 160, static_cast<float>(kDisparity_px));
    percept.saliency.salience = cv::Mat1f(120, 160, 0.0F);
  }
  Scene& hang(int seed, int u_px, int v_px) {
    thing(seed).copyTo(grey(cv::Rect(u_px - 60, v_px - 45, 120, 90)));
    return *this;
  }
  Scene& salient(double u_px, double v_px) {
    percept.saliency.regions.push_back({u_px / 4, v_px / 4, 30.0, 24.0, 1.0, 0.0, 2.0});
    return *this;
  }
  [[nodiscard]] ViewGeometry geometry() const { return {percept.disparity, {}, {}}; }
  /// Looks for all views, in their order.
  LandmarkLook look(LandmarkFinder& finder,
                    const std::vector<LandmarkExpectation>& expected = {}) const {
    std::vector<int> views(finder.views());
    std::iota(views.begin(), views.end(), 0);
    return finder.find(grey, geometry(), percept, {views, expected});
  }
};

LandmarkFinder finder_of(std::initializer_list<int> seeds, LandmarkFinderSettings settings = {}) {
  settings.every = 1;
  std::vector<KnownView> views;
  for (const int seed : seeds) views.push_back({seed, view_of(seed)});
  return LandmarkFinder(settings, views);
}

LandmarkExpectation expected_at(int landmark, const Scene& scene, double u_px, double v_px,
                                double disparity_px = kDisparity_px) {
  return {landmark, scene.geometry().point(u_px / 4, v_px / 4, disparity_px), 0.15};
}

TEST(LandmarkFinder, RecognisesInASalientRegionAndMeasuresWhereItIs) {
  LandmarkFinder finder = finder_of({1, 2});
  Scene scene;
  const LandmarkLook look = scene.hang(2, 440, 200).salient(440, 200).look(finder);
  ASSERT_EQ(look.recognitions.size(), 1U);
  const Recognition& found = look.recognitions[0];
  EXPECT_EQ(found.landmark, 2);
  EXPECT_NEAR(found.u_px, 440, 3);
  const SpacePoint place = scene.geometry().point(110.0, 49.9, kDisparity_px);
  EXPECT_NEAR(found.bearing_rad, std::atan2(place.y_m, place.x_m), 0.01);
  EXPECT_NEAR(found.distance_m, std::hypot(place.x_m, place.y_m), 0.02);
  EXPECT_NEAR(found.height_m, place.z_m, 0.03);
}

TEST(LandmarkFinder, LooksNowhereElse) {
  LandmarkFinder finder = finder_of({1});
  EXPECT_TRUE(Scene().hang(1, 440, 200).salient(100, 380).look(finder).recognitions.empty());
  EXPECT_TRUE(Scene().hang(1, 440, 200).look(finder).recognitions.empty());
}

TEST(LandmarkFinder, LooksWhereMemoryExpectsALandmarkAlsoIfNothingIsSalientThere) {
  LandmarkFinder finder = finder_of({1});
  Scene scene;
  const LandmarkLook look = scene.hang(1, 440, 200).look(finder, {expected_at(1, scene, 440, 200)});
  ASSERT_EQ(look.expected.size(), 1U);
  EXPECT_EQ(look.expected[0].result, LookResult::found);
  EXPECT_EQ(look.recognitions.size(), 1U);
}

TEST(LandmarkFinder, BelievesLessWhereItExpectsTheLandmark) {
  LandmarkFinderSettings settings;
  settings.matching.least_share = 1.1;  // more than can be had
  LandmarkFinder finder = finder_of({1, 2}, settings);
  Scene scene;
  scene.hang(1, 440, 200).salient(440, 200);
  EXPECT_TRUE(scene.look(finder).recognitions.empty());
  EXPECT_EQ(scene.look(finder, {expected_at(1, scene, 440, 200)}).recognitions.size(), 1U);
  EXPECT_TRUE(scene.look(finder, {expected_at(1, scene, 160, 200)}).recognitions.empty())
      << "elsewhere";
  EXPECT_TRUE(scene.look(finder, {expected_at(2, scene, 440, 200)}).recognitions.empty())
      << "another";
}

TEST(LandmarkFinder, SaysWhyAnExpectedLandmarkWasNotSeen) {
  LandmarkFinder finder = finder_of({1, 2});
  const auto result_of = [&](Scene& scene, const LandmarkExpectation& expected) {
    return scene.look(finder, {expected}).expected.at(0).result;
  };
  Scene scene;
  EXPECT_EQ(result_of(scene, expected_at(1, scene, 320, 240)), LookResult::missed);
  EXPECT_EQ(result_of(scene, expected_at(1, scene, 636, 240)), LookResult::out_of_view);
  EXPECT_EQ(result_of(scene, {1, {-2.0, 0.0, 1.0}, 0.15}), LookResult::out_of_view) << "behind";
  EXPECT_EQ(result_of(scene, expected_at(1, scene, 320, 240, 6.0)), LookResult::out_of_view)
      << "4 m";
  EXPECT_EQ(result_of(scene, expected_at(9, scene, 320, 240)), LookResult::not_looked_for);
  scene.percept.disparity.disparity_px.setTo(20.0F);  // at 1.2 m
  EXPECT_EQ(result_of(scene, expected_at(1, scene, 320, 240)), LookResult::hidden);
  scene.percept.disparity.disparity_px.setTo(kNoMatch);
  EXPECT_EQ(result_of(scene, expected_at(1, scene, 320, 240)), LookResult::missed);
  scene.percept.light_level = 0.05;
  EXPECT_EQ(result_of(scene, expected_at(1, scene, 320, 240)), LookResult::out_of_view) << "dark";
}

TEST(LandmarkFinder, ViewsBeyondTheBudgetTakeTurns) {
  LandmarkFinderSettings settings;
  settings.most_views = 4;
  LandmarkFinder finder = finder_of({1, 2, 3, 4, 5, 6}, settings);
  // Three always, and the others one after the other.
  int first = 0, last = 0;
  for (int image = 0; image < 6; ++image) {
    first += !Scene().hang(1, 320, 240).salient(320, 240).look(finder).recognitions.empty();
  }
  for (int image = 0; image < 6; ++image) {
    last += !Scene().hang(6, 320, 240).salient(320, 240).look(finder).recognitions.empty();
  }
  EXPECT_EQ(first, 6);
  EXPECT_EQ(last, 2);
}

TEST(LandmarkFinder, APartOfTheImageShowsOneThing) {
  LandmarkFinderSettings settings;
  settings.matching.least_share = 0.0;
  settings.every = 1;
  // The second landmark has the right half of the first in common with it.
  cv::Mat1b half = thing(2);
  thing(1)(cv::Rect(50, 0, 70, 90)).copyTo(half(cv::Rect(50, 0, 70, 90)));
  OrientedKeypoints oriented(OrientedSettings{});
  const LandmarkView like =
      make_view(half, {0, 0, 120, 90}, [&](const cv::Mat1b& grey) { return oriented(grey); });
  const std::vector<KnownView> one = {{2, like}}, both = {{2, like}, {1, view_of(1)}};
  Scene scene;
  scene.hang(1, 320, 240).salient(320, 240);
  LandmarkFinder of_one(settings, one), of_both(settings, both);
  EXPECT_EQ(scene.look(of_one).recognitions.size(), 1U);
  const LandmarkLook look = scene.look(of_both);
  ASSERT_EQ(look.recognitions.size(), 1U);
  EXPECT_EQ(look.recognitions[0].landmark, 1);
}

TEST(LandmarkFinder, WithoutAViewItDoesNothing) {
  LandmarkFinder finder{LandmarkFinderSettings{}};
  EXPECT_EQ(finder.views(), 0U);
  Scene scene;
  const LandmarkLook look =
      scene.hang(1, 320, 240).salient(320, 240).look(finder, {expected_at(1, scene, 320, 240)});
  EXPECT_TRUE(look.recognitions.empty());
  EXPECT_TRUE(look.expected.empty());
}

TEST(LookWindows, AreOfFewSizesLieInTheImageAndHoldTheirRegion) {
  LookWindows windows;
  windows.begin({640, 480}, 10);
  const std::vector<cv::Rect2d> boxes = {
      {10, 10, 50, 40}, {600, 440, 80, 80}, {200, 100, 250, 200}, {-20, 300, 100, 60}};
  for (const cv::Rect2d& box : boxes) windows.add(box);
  ASSERT_EQ(windows.windows().size(), boxes.size());
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const cv::Rect part = windows.windows()[k].part;
    const cv::Rect2d seen = boxes[k] & cv::Rect2d(0, 0, 640, 480);
    EXPECT_EQ(part & cv::Rect(0, 0, 640, 480), part);
    EXPECT_NEAR((cv::Rect2d(part) & seen).area(), seen.area(), 0.02 * seen.area());
  }
  windows.add({20, 15, 30, 30});
  EXPECT_EQ(windows.windows().size(), boxes.size()) << "it is looked at already";
  windows.begin({640, 480}, 1);
  windows.add(boxes[0]);
  windows.add(boxes[2]);
  EXPECT_EQ(windows.windows().size(), 1U);
}

}  // namespace
}  // namespace striate::perception
