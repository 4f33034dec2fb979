#include "striate/platform/interface/pixel_range.hpp"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <utility>

namespace striate {
namespace {

TEST(PixelRange, BitsAreThoseOfSensors) {
  for (const auto& [most, bits] : {std::pair{0, 8},
                                   {255, 8},
                                   {256, 10},
                                   {1023, 10},
                                   {1024, 12},
                                   {4095, 12},
                                   {16383, 14},
                                   {16384, 16},
                                   {65535, 16}}) {
    cv::Mat3w image(4, 4, cv::Vec3w(0, 0, 0));
    image(3, 1)[2] = static_cast<ushort>(most);
    EXPECT_EQ(bits_used(image), bits) << most;
  }
  EXPECT_EQ(bits_used(cv::Mat1b(2, 2, uchar{255})), 8);
  EXPECT_EQ(bits_used(cv::Mat()), 8);
}

TEST(PixelRange, TransparencyTellsNothingOfTheColours) {
  for (const int channels : {2, 4}) {
    cv::Mat image(4, 4, CV_16UC(channels), cv::Scalar::all(1000));
    std::vector<cv::Mat> parts;
    cv::split(image, parts);
    parts.back().setTo(65535);
    cv::merge(parts, image);
    EXPECT_EQ(bits_used(image), 10) << channels;
  }
}

TEST(PixelRange, WhiteIsWhiteWhateverItsValueIs) {
  for (const int bits : {8, 10, 12, 14, 16}) {
    const int most = most_of_bits(bits);
    const cv::Mat1w image = (cv::Mat1w(1, 3) << 0, most / 2, most);
    const cv::Mat1b shown = as_eight_bits(image, most);
    EXPECT_EQ(shown(0, 0), 0);
    EXPECT_NEAR(shown(0, 1), 127, 1);
    EXPECT_EQ(shown(0, 2), 255);
  }
}

}  // namespace
}  // namespace striate
