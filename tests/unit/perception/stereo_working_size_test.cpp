#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "striate/perception/stereo/shrink_by_four.hpp"
#include "striate/perception/stereo/stereo_matcher.hpp"

namespace striate::perception {
namespace {

cv::Mat random_image(const cv::Size& size, int type) {
  cv::Mat image(size, type);
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(WorkingSize, IsTheMeanOfTheAreaThatAPixelCovers) {
  cv::Mat1b image(8, 8, std::uint8_t{0});
  image.colRange(0, 2).setTo(100);
  const cv::Mat1b half = to_working_size(image, 2);
  EXPECT_EQ(half.size(), cv::Size(2, 2));
  EXPECT_EQ(half(0, 0), 50);
  EXPECT_EQ(half(0, 1), 0);
  EXPECT_EQ(to_working_size(cv::Mat3b(480, 640, cv::Vec3b(9, 9, 9)), 160).size(),
            cv::Size(160, 120));
  EXPECT_THROW(to_working_size(cv::Mat(), 160), std::invalid_argument);
  EXPECT_THROW(to_working_size(cv::Mat1f(4, 4), 160), std::invalid_argument);
}

TEST(WorkingSize, AQuarterIsWhatOpenCvMakesOfItBitForBit) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const cv::Mat image = random_image({640, 480}, type);
    cv::Mat theirs;
    cv::resize(image, theirs, {160, 120}, 0, 0, cv::INTER_AREA);
    EXPECT_TRUE(same(means_of_fours(image), theirs)) << image.channels() << " channels";
  }
  EXPECT_TRUE(same(to_working_size(random_image({640, 480}, CV_8UC1), 160),
                   means_of_fours(random_image({640, 480}, CV_8UC1))));
}

TEST(WorkingSize, SixteenthsOfAQuarterAreExact) {
  const cv::Mat1b image = random_image({640, 480}, CV_8UC1);
  cv::Mat1w theirs;
  image.convertTo(theirs, CV_16U, 16.0);
  cv::resize(theirs, theirs, {160, 120}, 0, 0, cv::INTER_AREA);
  EXPECT_TRUE(same(to_fine_working_size(image, 160), theirs));
}

TEST(WorkingSize, OtherFactorsAreShrunkToo) {
  for (const cv::Size size : {cv::Size(641, 480), cv::Size(640, 478), cv::Size(320, 240)}) {
    const cv::Mat1b image = random_image(size, CV_8UC1);
    EXPECT_EQ(to_working_size(image, 160).cols, 160);
    EXPECT_NEAR(cv::mean(to_fine_working_size(image, 160))[0], 16.0 * cv::mean(image)[0], 16.0);
  }
}

}  // namespace
}  // namespace striate::perception
