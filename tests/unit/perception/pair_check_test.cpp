#include "striate/perception/stereo/pair_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "tests/reference/scattered_pair.hpp"
#include "tests/reference/stereo_pairs.hpp"

namespace striate::perception {
namespace {

using reference::EyeImages;

cv::Mat1b moved(const cv::Mat1b& image, const cv::Matx23d& way) {
  cv::Mat1b result;
  cv::warpAffine(image, result, way, image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

cv::Mat1b shifted(const cv::Mat1b& image, double right_px, double down_px) {
  return moved(image, {1.0, 0.0, right_px, 0.0, 1.0, down_px});
}

cv::Mat1b rolled(const cv::Mat1b& image, double degrees) {
  const cv::Point2f middle(0.5F * static_cast<float>(image.cols),
                           0.5F * static_cast<float>(image.rows));
  return moved(image, cv::Mat1d(cv::getRotationMatrix2D(middle, degrees, 1.0)));
}

PairFault fault(const cv::Mat1b& left, const cv::Mat1b& right) {
  return fault_of(check_pair(left, right));
}

void expect_every_fault_is_seen(const EyeImages& eyes, const std::string& what) {
  const cv::Mat1b& left = eyes.left;
  const cv::Mat1b& right = eyes.right;
  const double px = left.cols / 100.0;
  EXPECT_EQ(fault(left, right), PairFault::none) << what;
  EXPECT_EQ(fault(right, left), PairFault::exchanged) << what;
  EXPECT_EQ(fault(left, left), PairFault::same) << what;
  EXPECT_EQ(fault(left, shifted(right, 0.0, px)), PairFault::rows) << what;
  EXPECT_EQ(fault(left, shifted(right, 0.0, -3.0 * px)), PairFault::rows) << what;
  EXPECT_EQ(fault(left, rolled(right, 2.0)), PairFault::unrectified) << what;
}

TEST(PairCheck, EyesThatAreExchangedIdenticalOffTheirRowsOrRolledAreEachSeen) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    expect_every_fault_is_seen(reference::scattered_pair(seed), std::to_string(seed));
  }
  expect_every_fault_is_seen(reference::scattered_pair(5, 60.0, 6.0, {320, 240}), "small");
}

// A second opinion where the public data are.
TEST(PairCheck, SeesThemInPhotographsToo) {
  const std::filesystem::path data = reference::shared_data(STRIATE_SHARED_DATA) + "/stereo";
  for (const auto& [left, right] :
       {std::pair<const char*, const char*>{"motorcycle/left.png", "motorcycle/right.png"},
        {"euroc/00_left.png", "euroc/00_right.png"},
        {"middlebury_2003/cones/imL.png", "middlebury_2003/cones/imR.png"}}) {
    if (!std::filesystem::exists(data / left)) continue;
    expect_every_fault_is_seen({cv::imread((data / left).string(), cv::IMREAD_GRAYSCALE),
                                cv::imread((data / right).string(), cv::IMREAD_GRAYSCALE)},
                               left);
  }
}

TEST(PairCheck, OnePictureWithTheNoiseOfTwoSensorsHasNoDepth) {
  const EyeImages eyes = reference::scattered_pair(7, 0.0, 0.0);
  EXPECT_EQ(fault(eyes.left, eyes.right), PairFault::flat);
}

TEST(PairCheck, WhatLiesBeyondInfinitySpeaksOfThePrincipalPoints) {
  const EyeImages eyes = reference::scattered_pair(8, 40.0, 16.0);
  EXPECT_EQ(fault(eyes.left, shifted(eyes.right, 30.0, 0.0)), PairFault::behind);
}

TEST(PairCheck, TooFewCornersSayNothing) {
  const cv::Mat1b plain(240, 320, uchar{90});
  EXPECT_EQ(fault(plain, plain), PairFault::unknown);
  EXPECT_EQ(fault({}, {}), PairFault::unknown);
  EXPECT_EQ(fault(plain, cv::Mat1b(120, 160, uchar{90})), PairFault::unknown);
  EXPECT_EQ(fault_text(check_pair(plain, plain), 320.0), "");
}

TEST(PairCheck, TellsRowsInPixelsOfTheImagesThatWereGiven) {
  const EyeImages eyes = reference::scattered_pair(9);
  const PairCheck check = check_pair(eyes.left, shifted(eyes.right, 0.0, 8.0));
  EXPECT_THAT(fault_text(check, 640.0),
              testing::ContainsRegex("lies (7\\.[5-9]|8\\.[0-5]) px lower"));
  EXPECT_NE(fault_hint(fault_of(check)), "");
}

}  // namespace
}  // namespace striate::perception
