#include "striate/perception/gist/gist.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "tests/reference/every_target.hpp"
#include "tests/reference/rendered_room.hpp"
#include "tests/reference/test_images.hpp"
#include "tests/reference/v1_reference.hpp"

namespace striate::perception {
namespace {

cv::Mat1b view_of_room(double along_m, double aside_m, double turn_rad, double light = 1.0,
                       double noise = 0.0) {
  reference::RenderedRoom room;
  room.light = light;
  room.noise = noise;
  return room.see(reference::room_pose({aside_m, 0.0, along_m}, {0.0, turn_rad, 0.0}), {160, 120})
      .left;
}

/// A gist by the book: V1 in double precision, means of roots, unit length.
std::vector<double> plain_gist(cv::Mat1b image) {
  V1Settings settings;
  settings.gamma = 1.0;
  std::vector<double> values;
  double square = 0.0;
  for (int scale = 0; scale < kGistScales; ++scale) {
    if (scale > 0) cv::resize(cv::Mat1b(image), image, image.size() / 2, 0, 0, cv::INTER_AREA);
    const reference::V1Reference v1 = reference::respond(image, settings);
    for (int part = 0; part < kGistParts * kGistParts; ++part) {
      const int width = image.cols / kGistParts, top_row = part / kGistParts;
      const int top = top_row * image.rows / kGistParts;
      const int bottom = (top_row + 1) * image.rows / kGistParts;
      for (const cv::Mat1d& energy : v1.energy) {
        double sum = 0.0;
        for (int y = top; y < bottom; ++y) {
          for (int x = part % kGistParts * width; x < (part % kGistParts + 1) * width; ++x) {
            sum += std::sqrt(std::sqrt(energy(y, x)));
          }
        }
        values.push_back(sum / (width * (bottom - top)));
        square += values.back() * values.back();
      }
    }
  }
  for (double& value : values) value *= kGistLength / std::sqrt(square);
  return values;
}

TEST(Gist, IsTheSameOnEveryInstructionSet) {
  GistFinder finder;
  const cv::Mat1b image = reference::texture({211, 97}, 5);
  const Gist plain = finder.find(image);
  EXPECT_FALSE(plain.blank());
  reference::on_every_target(
      [&](const std::string& name) { EXPECT_EQ(finder.find(image), plain) << name; });
}

TEST(Gist, IsWhatDoublePrecisionSays) {
  const cv::Mat1b image = view_of_room(0.0, 0.0, 0.0);
  const Gist gist = GistFinder().find(image);
  const std::vector<double> plain = plain_gist(image);
  ASSERT_EQ(plain.size(), gist.values.size());
  for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_NEAR(gist.values[k], plain[k], 2.0) << k;
}

TEST(Gist, OtherLightHardlyChangesIt) {
  GistFinder finder;
  const cv::Mat1b image = view_of_room(0.0, 0.0, 0.0);
  const Gist gist = finder.find(image);
  const Gist other_place = finder.find(view_of_room(2.0, 0.0, 0.0));
  for (const auto& [contrast, brightness] :
       {std::pair(1.0, 20.0), std::pair(0.5, 0.0), std::pair(0.4, 100.0)}) {
    cv::Mat1b changed;
    image.convertTo(changed, CV_8U, contrast, brightness);
    const double distance = gist_distance(gist, finder.find(changed));
    EXPECT_LT(distance, 0.05) << contrast << " " << brightness;
    EXPECT_LT(3.0 * distance, gist_distance(gist, other_place));
  }
}

TEST(Gist, IsNearestWhereTheEyeHasBeenBefore) {
  GistFinder finder;
  std::vector<Gist> places;
  for (int k = 0; k < 9; ++k) places.push_back(finder.find(view_of_room(k - 2.0, 0.0, 0.0)));
  for (int k = 0; k < 9; ++k) {
    const Gist again = finder.find(view_of_room(k - 1.9, 0.05, 0.02, 0.7, 2.0));
    const auto nearest = std::ranges::min_element(
        places, {}, [&](const Gist& place) { return gist_distance(place, again); });
    EXPECT_EQ(nearest - places.begin(), k);
  }
}

TEST(Gist, OfABlankImageIsBlankAndFarFromAll) {
  GistFinder finder;
  const Gist blank = finder.find(cv::Mat1b(48, 64, std::uint8_t{130}));
  EXPECT_TRUE(blank.blank());
  EXPECT_DOUBLE_EQ(gist_distance(blank, blank), std::numbers::sqrt2);
  const Gist other = finder.find(reference::texture({64, 48}, 1));
  EXPECT_DOUBLE_EQ(gist_distance(blank, other), std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(gist_distance(other, other), 0.0);
  EXPECT_TRUE(finder.find(cv::Mat1b(1, 1, std::uint8_t{9})).blank());
  EXPECT_THROW((void)finder.find(cv::Mat1b()), std::invalid_argument);
}

}  // namespace
}  // namespace striate::perception
