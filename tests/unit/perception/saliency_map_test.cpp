#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/perception/saliency/saliency.hpp"
#include "tests/reference/saliency_reference.hpp"
#include "tests/reference/stereo_pairs.hpp"
#include "tests/unit/perception/obstacles_synthetic_room.hpp"

namespace striate::perception {
namespace {

/// Greyish noise with coloured patches at known places.
cv::Mat3b scene() {
  cv::Mat3b image(120, 160);
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const double n = 6.0 * synthetic::noise(static_cast<std::uint64_t>(v) * 160 + u);
      image(v, u) = cv::Vec3b(cv::saturate_cast<uchar>(120 + 0.3 * u + n),
                              cv::saturate_cast<uchar>(125 + 0.3 * u + n),
                              cv::saturate_cast<uchar>(118 + 0.3 * v + n));
    }
  }
  cv::rectangle(image, {30, 40, 16, 20}, {30, 30, 210}, cv::FILLED);
  cv::rectangle(image, {110, 70, 10, 10}, {200, 120, 30}, cv::FILLED);
  return image;
}

DisparityMap disparity_with_near_box() {
  DisparityMap map = synthetic::empty_map();
  map.disparity_px.setTo(3.0F);
  map.disparity_px(cv::Rect(100, 20, 24, 30)).setTo(14.0F);
  map.disparity_px(cv::Rect(0, 100, 40, 20)).setTo(kNoMatch);
  map.confidence.setTo(0.9F);
  return map;
}

SaliencyMap find(const cv::Mat3b& image, const DisparityMap& map) {
  return find_salience(image, map, ViewGeometry(map, {}, {}), {});
}

void expect_close_to_reference(const cv::Mat3b& image, const DisparityMap& map) {
  const SaliencySettings s;
  const cv::Mat1f fast = find(image, map).salience;
  const cv::Mat1d plain =
      reference::salience(image, map.disparity_px, s.near_px, s.near_gain, s.least_contrast);
  double worst = 0.0;
  double mean = 0.0;
  for (int v = 0; v < fast.rows; ++v) {
    for (int u = 0; u < fast.cols; ++u) {
      const double error = std::abs(fast(v, u) - plain(v, u));
      worst = std::max(worst, error);
      mean += error / static_cast<double>(fast.total());
    }
  }
  testing::Test::RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(mean, 0.012);
  EXPECT_LT(worst, 0.06);
}

TEST(Saliency, AgreesWithTheDirectSumOfThePaper) {
  expect_close_to_reference(scene(), disparity_with_near_box());
  expect_close_to_reference(scene(), synthetic::empty_map());
}

TEST(Saliency, AgreesWithTheDirectSumOnImagesOfRoomsAndAPhotograph) {
  std::vector<cv::Mat3b> pictures;
  for (const std::uint64_t seed : {1, 2}) {
    pictures.push_back(reference::PaintedRoom(seed).paint().left);
  }
  const std::string photograph =
      reference::shared_data(STRIATE_SHARED_DATA) + "/stereo/motorcycle/left.png";
  if (std::filesystem::exists(photograph)) pictures.push_back(cv::imread(photograph));
  for (cv::Mat3b& image : pictures) {
    cv::resize(image, image, {160, 120}, 0, 0, cv::INTER_AREA);
    expect_close_to_reference(image, synthetic::empty_map());
  }
}

TEST(Saliency, PointsAtTheColouredPatchMostSalientFirst) {
  const SaliencyMap map = find(scene(), synthetic::empty_map());
  ASSERT_FALSE(map.regions.empty());
  EXPECT_NEAR(map.regions[0].u_px, 37.5, 4.0);
  EXPECT_NEAR(map.regions[0].v_px, 49.5, 4.0);
  EXPECT_NEAR(map.regions[0].salience, 1.0, 1e-6);
  EXPECT_EQ(map.regions[0].distance_m, kNothing_m);
  EXPECT_GT(map.regions[0].bearing_rad, 0.1);  // left of the middle is a positive bearing
  for (std::size_t i = 1; i < map.regions.size(); ++i) {
    EXPECT_GE(map.regions[i - 1].salience, map.regions[i].salience);
  }
}

TEST(Saliency, ANearThingIsSalientAndHasItsDistance) {
  const cv::Mat3b grey(120, 160, cv::Vec3b(128, 128, 128));
  const SaliencyMap map = find(grey, disparity_with_near_box());
  ASSERT_FALSE(map.regions.empty());
  EXPECT_NEAR(map.regions[0].u_px, 111.5, 3.0);
  EXPECT_NEAR(map.regions[0].distance_m, 203.0 * 0.12 / 14.0, 0.1);
}

TEST(Saliency, NoiseOnABlankWallStaysDim) {
  cv::Mat3b image(120, 160);
  for (int i = 0; i < 120 * 160; ++i) {
    const double n = 3.0 * synthetic::noise(i);
    image(i / 160, i % 160) = cv::Vec3b::all(cv::saturate_cast<uchar>(100.0 + n));
  }
  EXPECT_TRUE(find(image, synthetic::empty_map()).regions.empty());
}

TEST(Saliency, TakesAnyImageSize) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 5), cv::Size(161, 107)}) {
    const cv::Mat3b image(size, cv::Vec3b(1, 2, 3));
    EXPECT_EQ(find(image, {}).salience.size(), size);
  }
  EXPECT_TRUE(find({}, {}).salience.empty());
}

TEST(Gaussian, GivesTheBitsOfOpenCVs) {
  cv::Mat_<cv::Vec4f> plane(31, 43);
  cv::theRNG().state = 5;
  cv::randu(plane, 0.0, 300.0);
  for (const double sigma_px : {0.3, 1.0, 2.7, 6.0}) {
    cv::Mat fast, plain;
    Gaussian(sigma_px).blur(plane, fast);
    cv::GaussianBlur(plane, plain, {0, 0}, sigma_px, sigma_px, cv::BORDER_REFLECT);
    EXPECT_EQ(cv::norm(fast, plain, cv::NORM_INF), 0.0) << sigma_px;
  }
}

}  // namespace
}  // namespace striate::perception
