#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "striate/base/user_error.hpp"
#include "striate/perception/descriptor/dense_descriptor.hpp"
#include "striate/perception/keypoints/keypoints.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::perception {
namespace {

double nearest_px(const std::vector<Keypoint>& found, double u, double v) {
  double nearest = 1e9;
  for (const Keypoint& point : found) {
    nearest = std::min(nearest, std::hypot(point.u_px - u, point.v_px - v));
  }
  return nearest;
}

TEST(KeypointFinder, FindsTheCornersOfASquareAndNothingOnItsSides) {
  for (const bool halve : {false, true}) {
    KeypointSettings settings;
    settings.halve = halve;
    cv::Mat1b image(160, 200, std::uint8_t{60});
    image(cv::Rect(60, 40, 80, 80)).setTo(180);
    const std::vector<Keypoint> found = find_keypoints(image, settings);
    for (const auto& [u, v] :
         {std::pair{59.5, 39.5}, {139.5, 39.5}, {59.5, 119.5}, {139.5, 119.5}}) {
      EXPECT_LT(nearest_px(found, u, v), 5.0) << "halved: " << halve;
    }
    EXPECT_GT(nearest_px(found, 99.5, 39.5), 15.0) << "the middle of the upper side";
    EXPECT_GT(nearest_px(found, 100.0, 80.0), 15.0) << "the inside";
  }
}

TEST(KeypointFinder, FindsTheSameThingsInAShiftedImage) {
  const cv::Mat1b wide = reference::texture({240, 160}, 3);
  const auto here = find_keypoints(wide(cv::Rect(0, 0, 200, 160)).clone(), {});
  const auto there = find_keypoints(wide(cv::Rect(12, 0, 200, 160)).clone(), {});
  ASSERT_GT(here.size(), 30U);
  int inside = 0, again = 0, same = 0;
  for (const Keypoint& point : here) {
    if (point.u_px < 50 || point.u_px > 180 || point.v_px < 30 || point.v_px > 130) continue;
    ++inside;
    for (const Keypoint& other : there) {
      if (std::hypot(other.u_px + 12 - point.u_px, other.v_px - point.v_px) > 0.1) continue;
      ++again;
      same += hamming_distance(point.descriptor, other.descriptor) <= 4;
    }
  }
  ASSERT_GT(inside, 15);
  EXPECT_GE(again, 0.9 * inside);
  EXPECT_GE(same, 0.9 * inside);
}

TEST(KeypointFinder, LocatesTheSameKeypointsWithoutDescribingThem) {
  const cv::Mat1b image = reference::texture({200, 160}, 3);
  KeypointFinder finder({});
  std::vector<Keypoint> located;
  finder.locate(image, located);
  const std::vector<Keypoint> found = finder.find(image);
  ASSERT_EQ(located.size(), found.size());
  ASSERT_FALSE(found.empty());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(located[k].u_px, found[k].u_px);
    EXPECT_EQ(located[k].response, found[k].response);
    EXPECT_EQ(located[k].descriptor, Descriptor{});
    EXPECT_NE(found[k].descriptor, Descriptor{});
  }
}

TEST(KeypointFinder, ComesStrongestFirstAndKeepsOnlyTheMost) {
  KeypointSettings settings;
  const cv::Mat1b image = reference::texture({200, 160}, 5);
  const auto all = find_keypoints(image, settings);
  settings.most = 10;
  const auto few = find_keypoints(image, settings);
  ASSERT_GT(all.size(), 10U);
  ASSERT_EQ(few.size(), 10U);
  for (std::size_t k = 0; k < few.size(); ++k) {
    EXPECT_EQ(few[k].descriptor, all[k].descriptor);
    if (k > 0) {
      EXPECT_LE(few[k].response, few[k - 1].response);
    }
  }
}

/// A square of `side_px`, odd, in a blank image of 320x320, centred at (155, 155).
cv::Mat1b square(int side_px) {
  cv::Mat1b image(320, 320, std::uint8_t{60});
  image(cv::Rect(155 - side_px / 2, 155 - side_px / 2, side_px, side_px)).setTo(180);
  return image;
}

KeypointSettings many_scales() {
  KeypointSettings settings;
  settings.wavelength_px = 4.0;
  settings.halve = false;
  settings.scales = 9;
  return settings;
}

TEST(KeypointFinder, TheWavelengthFollowsTheSizeOfABlob) {
  KeypointSettings settings = many_scales();
  settings.fine_first = 0.0;
  double last_px = 0.0;
  for (const int side_px : {5, 9, 17}) {
    double strongest = 0.0, wavelength_px = 0.0;
    for (const Keypoint& point : find_keypoints(square(side_px), settings)) {
      if (std::hypot(point.u_px - 155, point.v_px - 155) > 0.4 * side_px) continue;
      if (point.response > strongest) {
        strongest = point.response;
        wavelength_px = point.wavelength_px;
      }
    }
    EXPECT_GT(wavelength_px, last_px) << "a square of " << side_px << " px";
    EXPECT_GT(wavelength_px, 1.0 * side_px);
    EXPECT_LT(wavelength_px, 4.0 * side_px);
    last_px = wavelength_px;
  }
}

TEST(KeypointFinder, WavelengthsAreTwoPerOctaveInPixelsOfTheGivenImage) {
  KeypointSettings settings = many_scales();
  settings.fine_first = 0.0;
  const auto found = find_keypoints(reference::texture({320, 240}, 4), settings);
  std::set<int> steps;
  for (const Keypoint& point : found) {
    const double step = 2.0 * std::log2(point.wavelength_px / 4.0);
    EXPECT_NEAR(step, std::round(step), 1e-9);
    steps.insert(static_cast<int>(std::lround(step)));
    EXPECT_GE(point.u_px, 3.5);
    EXPECT_LE(point.u_px, 320 - 4.5);
    EXPECT_GE(point.v_px, 3.5);
    EXPECT_LE(point.v_px, 240 - 4.5);
  }
  EXPECT_TRUE(steps.contains(0));
  EXPECT_TRUE(steps.contains(5));
  EXPECT_LE(*steps.rbegin(), 8);
}

TEST(KeypointFinder, KeypointsOfNeighbouringScalesAreApart) {
  KeypointSettings settings = many_scales();
  const auto found = find_keypoints(reference::texture({200, 160}, 7), settings);
  ASSERT_GT(found.size(), 100U);
  for (std::size_t a = 0; a < found.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double larger_px = std::max(found[a].wavelength_px, found[b].wavelength_px);
      const double smaller_px = std::min(found[a].wavelength_px, found[b].wavelength_px);
      if (larger_px > 2.01 * smaller_px) continue;
      EXPECT_GE(std::hypot(found[a].u_px - found[b].u_px, found[a].v_px - found[b].v_px),
                settings.apart * larger_px - 1e-9);
    }
  }
}

TEST(KeypointFinder, ACornerIsFoundWithinAPixelOfItselfInAnImageOfTwiceTheSize) {
  cv::Mat1b small(120, 120, std::uint8_t{60}), large(240, 240, std::uint8_t{60});
  small(cv::Rect(40, 40, 40, 40)).setTo(180);
  large(cv::Rect(80, 80, 80, 80)).setTo(180);
  KeypointSettings once, twice;
  once.wavelength_px = 4.0;
  once.halve = false;
  const auto in_small = find_keypoints(small, once);
  const auto in_large = find_keypoints(large, twice);
  ASSERT_EQ(in_small.size(), in_large.size());
  for (const Keypoint& point : in_small) {
    EXPECT_LT(nearest_px(in_large, 2.0 * point.u_px + 0.5, 2.0 * point.v_px + 0.5), 0.01);
  }
}

TEST(KeypointFinder, UsesItsBuffersAgainForAnotherImage) {
  KeypointFinder finder(many_scales());
  std::vector<Keypoint> out;
  finder.find(reference::texture({200, 160}, 1), out);
  finder.find(cv::Mat1b(50, 60, std::uint8_t{9}), out);
  EXPECT_TRUE(out.empty());
  finder.find(reference::texture({200, 160}, 2), out);
  const auto fresh = find_keypoints(reference::texture({200, 160}, 2), many_scales());
  ASSERT_EQ(out.size(), fresh.size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    EXPECT_EQ(out[k].u_px, fresh[k].u_px);
    EXPECT_EQ(out[k].descriptor, fresh[k].descriptor);
  }
}

TEST(KeypointFinder, GivesTheSameOnEveryInstructionSet) {
  const cv::Mat1b image = reference::texture({131, 97}, 8);
  std::vector<Keypoint> first;
  reference::on_every_target([&](const std::string& name) {
    const auto found = find_keypoints(image, many_scales());
    if (first.empty()) first = found;
    ASSERT_EQ(found.size(), first.size()) << name;
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_EQ(found[k].u_px, first[k].u_px) << name;
      ASSERT_EQ(found[k].response, first[k].response) << name;
      ASSERT_EQ(found[k].descriptor, first[k].descriptor) << name;
    }
  });
  EXPECT_GT(first.size(), 50U);
}

TEST(KeypointFinder, TakesImagesOfAnySizeAndFindsNothingInBlankOnes) {
  KeypointSettings full = many_scales(), halved;
  for (const KeypointSettings& settings : {full, halved}) {
    for (const cv::Size size :
         {cv::Size(1, 1), cv::Size(2, 2), cv::Size(3, 50), cv::Size(97, 61)}) {
      EXPECT_TRUE(find_keypoints(cv::Mat1b(size, std::uint8_t{0}), settings).empty());
      EXPECT_TRUE(find_keypoints(cv::Mat1b(size, std::uint8_t{255}), settings).empty());
      for (const Keypoint& point : find_keypoints(reference::texture(size, 1), settings)) {
        EXPECT_GE(point.u_px, 0.0);
        EXPECT_LT(point.u_px, size.width);
      }
    }
  }
  EXPECT_THROW(find_keypoints(cv::Mat1b(), {}), std::invalid_argument);
}

TEST(KeypointFinder, RefusesAWavelengthThatTheFiltersCannotHave) {
  KeypointSettings settings;
  settings.wavelength_px = 4.0;  // 2 px on the halved image
  EXPECT_THROW(KeypointFinder{settings}, UserError);
  settings.wavelength_px = 10.0;
  settings.halve = false;
  EXPECT_NO_THROW(KeypointFinder{settings});
  settings.scales = 2;  // 14 px on the same level
  EXPECT_THROW(KeypointFinder{settings}, UserError);
}

}  // namespace
}  // namespace striate::perception
