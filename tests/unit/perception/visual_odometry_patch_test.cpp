#include <gtest/gtest.h>

#include "striate/perception/visual_odometry/patch_place.hpp"
#include "tests/reference/rendered_room.hpp"

namespace striate::perception {
namespace {

/// Smooth texture, moved and zoomed, in another light.
cv::Mat1b moved_texture(double du, double dv, double zoom, double gain, double offset) {
  cv::Mat1b image(120, 160);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double x = 80.0 + (u - du - 80.0) / zoom, y = 60.0 + (v - dv - 60.0) / zoom;
      double sum = 0.0;
      for (const double grain : {4.0, 9.0, 20.0}) {
        sum += reference::smooth_noise(x / grain, y / grain, static_cast<int>(grain));
      }
      image(v, u) = cv::saturate_cast<std::uint8_t>(gain * (120.0 + 35.0 * sum) + offset);
    }
  }
  return image;
}

PatchPlace place_of(const cv::Mat1b& from, const cv::Mat1b& to, cv::Point2d start,
                    double zoom = 1.0, int level = 0) {
  PicturePyramid a, b;
  a.build(from);
  b.build(to);
  return find_patch(a, {80.0, 60.0}, b, start, cv::Matx22d::eye() * (1.0 / zoom), level, {});
}

TEST(PatchPlaceTest, IsFoundToAFewHundredthsOfAPixelInAnotherLight) {
  const cv::Mat1b here = moved_texture(0, 0, 1, 1, 0);
  for (const double shift : {-1.4, -0.5, 0.3, 0.77, 1.5}) {
    const PatchPlace place =
        place_of(here, moved_texture(shift, -0.5 * shift, 1, 0.6, 20.0), {80.0, 60.0});
    ASSERT_EQ(place.result, PatchPlace::Result::found) << shift;
    EXPECT_NEAR(place.u_px, 80.0 + shift, 0.05);
    EXPECT_NEAR(place.v_px, 60.0 - 0.5 * shift, 0.05);
  }
}

TEST(PatchPlaceTest, IsFoundInAZoomedImageAndOnACoarserLevel) {
  const cv::Mat1b here = moved_texture(0, 0, 1, 1, 0);
  const PatchPlace zoomed = place_of(here, moved_texture(0.6, 0.4, 1.25, 1, 0), {80.0, 60.0}, 1.25);
  ASSERT_EQ(zoomed.result, PatchPlace::Result::found);
  EXPECT_NEAR(zoomed.u_px, 80.6, 0.08);
  EXPECT_NEAR(zoomed.v_px, 60.4, 0.08);
  const PatchPlace coarse = place_of(here, moved_texture(2.4, -1.2, 1, 1, 0), {80.0, 60.0}, 1.0, 1);
  ASSERT_EQ(coarse.result, PatchPlace::Result::found);
  EXPECT_NEAR(coarse.u_px, 82.4, 0.1);
  EXPECT_NEAR(coarse.v_px, 58.8, 0.1);
}

TEST(PatchPlaceTest, IsNotFoundOnNothingOnAnEdgeOutsideOrWhereSomethingElseIs) {
  const cv::Mat1b texture = moved_texture(0, 0, 1, 1, 0);
  const cv::Mat1b blank(120, 160, std::uint8_t{90});
  EXPECT_EQ(place_of(blank, blank, {80.0, 60.0}).result, PatchPlace::Result::without_contrast);
  cv::Mat1b edge = blank.clone();
  edge(cv::Rect(80, 0, 80, 120)).setTo(180);
  EXPECT_EQ(place_of(edge, edge, {80.0, 60.0}).result, PatchPlace::Result::without_contrast);
  EXPECT_NE(place_of(texture, blank, {80.0, 60.0}).result, PatchPlace::Result::found);
  EXPECT_NE(place_of(texture, moved_texture(40, 30, 1, 1, 0), {80.0, 60.0}).result,
            PatchPlace::Result::found);
  EXPECT_EQ(place_of(texture, texture, {2.0, 2.0}).result, PatchPlace::Result::outside);
  EXPECT_EQ(place_of(texture, texture, {std::nan(""), 60.0}).result, PatchPlace::Result::outside);
}

}  // namespace
}  // namespace striate::perception
