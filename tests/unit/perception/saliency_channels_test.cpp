#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "perception/saliency/saliency.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/test_pictures.hpp"

namespace striate {
namespace {

cv::Mat3b coloured(const cv::Mat1b& grey) {
  cv::Mat3b picture;
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
  return picture;
}

SaliencySettings only(double SaliencySettings::*channel) {
  SaliencySettings settings;
  settings.colour = settings.texture = settings.shape = settings.near = settings.motion = 0.0;
  settings.*channel = 1.0;
  return settings;
}

SaliencyMap find(SaliencyFinder& finder, const cv::Mat1b& grey) {
  return finder.find(coloured(grey), {}, ViewGeometry({}, {}, {}));
}

cv::Point highest(const SaliencyMap& map) {
  cv::Point at;
  cv::minMaxLoc(map.salience, nullptr, nullptr, nullptr, &at);
  return at;
}

TEST(SaliencyChannels, TextureFindsThePatchOfOtherOrientation) {
  cv::Mat1b picture(120, 160);
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const bool patch = std::abs(u - 110) < 15 && std::abs(v - 50) < 15;
      picture(v, u) = static_cast<uchar>(128.0 + 60.0 * std::sin(1.57 * (patch ? v : u)));
    }
  }
  SaliencyFinder finder(only(&SaliencySettings::texture));
  const cv::Point at = highest(find(finder, picture));
  EXPECT_NEAR(at.x, 110, 12);
  EXPECT_NEAR(at.y, 50, 12);
}

TEST(SaliencyChannels, ShapeFindsTheMiddleOfARing) {
  cv::Mat1b picture(120, 160, uchar{90});
  cv::circle(picture, {60, 70}, 16, 200, 2);
  cv::line(picture, {120, 0}, {120, 119}, 200, 2);
  SaliencyFinder finder(only(&SaliencySettings::shape));
  const cv::Point at = highest(find(finder, picture));
  EXPECT_NEAR(at.x, 60, 4);
  EXPECT_NEAR(at.y, 70, 4);
}

TEST(SaliencyChannels, MotionFindsWhatMovesAndNotTheTurnOfTheHead) {
  SaliencyFinder finder(only(&SaliencySettings::motion));
  find(finder, reference::texture({160, 120}, 3));
  cv::Mat1b now = reference::texture({160, 120}, 3, 6);  // all shifts by 6 px
  EXPECT_TRUE(find(finder, now).regions.empty());
  now = reference::texture({160, 120}, 3, 12);
  reference::texture({20, 20}, 9).copyTo(now(cv::Rect(40, 50, 20, 20)));
  const cv::Point at = highest(find(finder, now));
  EXPECT_NEAR(at.x, 50, 10);
  EXPECT_NEAR(at.y, 60, 10);
}

TEST(SaliencyChannels, EnergyAndTheShapeOfEveryInstructionSetAreTheSame) {
  const cv::Mat1b picture = reference::texture({161, 107}, 5);
  cv::Mat1f first;
  reference::on_every_target([&](const std::string& name) {
    SaliencyFinder finder{SaliencySettings{}};
    const cv::Mat1f now = find(finder, picture).salience;
    if (first.empty()) first = now;
    EXPECT_EQ(cv::norm(first, now, cv::NORM_INF), 0.0) << name;
  });
}

TEST(SaliencyChannels, ShapeIsTheSumOfItsFormula) {
  OrientedEnergy energy;
  for (std::size_t i = 0; i < energy.size(); ++i) {
    cv::Mat1f plane;
    reference::texture({40, 30}, static_cast<int>(i)).convertTo(plane, CV_32F);
    energy[i] = plane;
  }
  cv::Mat1f sum(30, 40, 0.0F);
  add_shape(energy, 5.0, sum);
  for (const cv::Point p : {cv::Point(10, 12), cv::Point(25, 20)}) {
    double plain = 0.0;
    for (int i = 0; i < 8; ++i) {
      const double theta = i * 3.14159265358979 / 8.0;
      const cv::Point n(static_cast<int>(std::lround(5.0 * std::cos(theta))),
                        static_cast<int>(std::lround(5.0 * std::sin(theta))));
      plain += std::min(energy[static_cast<std::size_t>(i)](p + n),
                        energy[static_cast<std::size_t>(i)](p - n));
    }
    EXPECT_NEAR(sum(p), plain, 1e-3);
  }
}

TEST(SaliencyChannels, EveryPictureSizeAndABlankOneGiveAnAnswer) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 5), cv::Size(161, 107)}) {
    SaliencySettings all;
    all.motion = 1.0;
    SaliencyFinder finder(all);
    const cv::Mat1b blank(size, uchar{255});
    EXPECT_EQ(find(finder, blank).salience.size(), size);
    EXPECT_TRUE(find(finder, blank).regions.empty());
  }
}

}  // namespace
}  // namespace striate
