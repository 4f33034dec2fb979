#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "striate/perception/saliency/saliency.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/salience_channels_reference.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::perception {
namespace {

cv::Mat3b coloured(const cv::Mat1b& grey) {
  cv::Mat3b image;
  cv::cvtColor(grey, image, cv::COLOR_GRAY2BGR);
  return image;
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
  cv::Mat1b image(120, 160);
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const bool patch = std::abs(u - 110) < 15 && std::abs(v - 50) < 15;
      image(v, u) = static_cast<uchar>(128.0 + 60.0 * std::sin(1.57 * (patch ? v : u)));
    }
  }
  SaliencyFinder finder(only(&SaliencySettings::texture));
  const cv::Point at = highest(find(finder, image));
  EXPECT_NEAR(at.x, 110, 12);
  EXPECT_NEAR(at.y, 50, 12);
}

TEST(SaliencyChannels, ShapeFindsTheMiddleOfARing) {
  cv::Mat1b image(120, 160, uchar{90});
  cv::circle(image, {60, 70}, 16, 200, 2);
  cv::line(image, {120, 0}, {120, 119}, 200, 2);
  SaliencyFinder finder(only(&SaliencySettings::shape));
  const cv::Point at = highest(find(finder, image));
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
  const cv::Mat1b image = reference::texture({161, 107}, 5);
  cv::Mat1f first;
  reference::on_every_target([&](const std::string& name) {
    SaliencyFinder finder{SaliencySettings{}};
    const cv::Mat1f now = find(finder, image).salience;
    if (first.empty()) first = now;
    EXPECT_EQ(cv::norm(first, now, cv::NORM_INF), 0.0) << name;
  });
}

void expect_close(const cv::Mat1f& fast, const cv::Mat1d& plain, double bound,
                  const std::string& what) {
  ASSERT_EQ(fast.size(), plain.size()) << what;
  cv::Mat1d as_double;
  fast.convertTo(as_double, CV_64F);
  EXPECT_LT(cv::norm(as_double, plain, cv::NORM_INF), bound * cv::norm(plain, cv::NORM_INF))
      << what;
}

TEST(SaliencyChannels, TextureAndShapeFollowTheirFormulasOnEveryInstructionSet) {
  const cv::Mat1b image = reference::texture({163, 118}, 5);
  V1Responses responses;
  V1Cells(V1Settings{}).respond(image, 0, false, responses);
  reference::Energy energy;
  for (std::size_t i = 0; i < energy.size(); ++i) {
    cv::Mat1d plane(image.size());
    for (int v = 0; v < plane.rows; ++v) {
      for (int u = 0; u < plane.cols; ++u) {
        plane(v, u) = complex_response(responses.code[i].row(v)[u]) / responses.gain;
      }
    }
    energy[i] = reference::block_means(plane);
  }
  reference::on_every_target([&](const std::string& name) {
    V1Channels channels;
    channels.average(responses);
    for (std::size_t i = 0; i < energy.size(); ++i) {
      expect_close(channels.energy()[i], energy[i], 0.005, name + " energy");  // whole amplitudes
    }
    cv::Mat1f channel;
    channels.texture(channel);
    expect_close(channel, reference::texture_channel(energy), 0.02, name + " texture");
    channels.shape(channel);
    expect_close(channel, reference::shape_channel(energy), 0.005, name + " shape");
  });
}

TEST(SaliencyChannels, MotionFollowsItsFormulaOnEveryInstructionSet) {
  cv::Mat1b now = reference::texture({80, 61}, 3, 4);
  reference::texture({12, 15}, 9).copyTo(now(cv::Rect(40, 20, 12, 15)));
  cv::Mat1f before_f, now_f;
  cv::Mat1d before_d, now_d;
  const cv::Mat1b before = reference::texture({80, 61}, 3);
  before.convertTo(before_f, CV_32F), now.convertTo(now_f, CV_32F);
  before.convertTo(before_d, CV_64F), now.convertTo(now_d, CV_64F);
  cv::Point shift;
  const cv::Mat1d plain = reference::motion_channel(now_d, before_d, shift);
  EXPECT_EQ(shift, cv::Point(4, 0));
  reference::on_every_target([&](const std::string& name) {
    ImageChange change;
    cv::Mat1f sum(now.size(), 0.0F);
    change.add(before_f, sum);
    change.add(now_f, sum);
    EXPECT_EQ(change.shift_px(), shift) << name;
    expect_close(sum, plain, 1e-6, name);
  });
}

/// Texture that is the same all over: what lies near the border must not respond less.
TEST(SaliencyChannels, TheBorderIsNeitherPreferredNorOverlooked) {
  cv::Mat1d mean(30, 40, 0.0);
  for (int k = 0; k < 40; ++k) {
    V1Responses responses;
    V1Cells(V1Settings{}).respond(reference::texture({160, 120}, 100 + k), 0, false, responses);
    V1Channels channels;
    channels.average(responses);
    cv::Mat1f texture, shape;
    channels.texture(texture);
    channels.shape(shape);
    for (int v = 0; v < mean.rows; ++v) {
      for (int u = 0; u < mean.cols; ++u) mean(v, u) += shape(v, u) + texture(v, u);
    }
  }
  const double middle = cv::mean(mean(cv::Rect(8, 8, 24, 14)))[0];
  const cv::Rect borders[] = {{0, 0, 40, 6}, {0, 24, 40, 6}, {0, 0, 6, 30}, {34, 0, 6, 30}};
  for (const cv::Rect& border : borders) {
    EXPECT_NEAR(cv::mean(mean(border))[0] / middle, 1.0, 0.05) << border;
  }
}

TEST(SaliencyChannels, EveryImageSizeAndABlankOneGiveAnAnswer) {
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
}  // namespace striate::perception
