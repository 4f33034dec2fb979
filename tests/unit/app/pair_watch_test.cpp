#include "striate/app/pair_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reference/scattered_pair.hpp"

namespace striate::app {
namespace {

StereoFrame frame_of(const cv::Mat1b& left, const cv::Mat1b& right, double at_s) {
  StereoFrame frame;
  frame.stamp = TimePoint(from_seconds(at_s));
  cv::cvtColor(left, frame.left, cv::COLOR_GRAY2BGR);
  cv::cvtColor(right, frame.right, cv::COLOR_GRAY2BGR);
  return frame;
}

TEST(PairWatch, ExchangedEyesAreSaidOnceAndRightOnesNever) {
  const reference::EyeImages eyes = reference::scattered_pair(2);
  for (const bool exchanged : {false, true}) {
    PairWatch watch;
    std::string said;
    for (int cycle = 0; cycle < 30; ++cycle) {
      watch.take(frame_of(exchanged ? eyes.right : eyes.left, exchanged ? eyes.left : eyes.right,
                          0.5 * cycle));
      said += watch.news();
    }
    said += watch.finish();
    said += watch.finish();
    if (!exchanged) {
      EXPECT_EQ(said, "");
      continue;
    }
    EXPECT_THAT(said, testing::HasSubstr("exchanged"));
    EXPECT_EQ(said.find("warning:"), said.rfind("warning:")) << "once";
  }
}

TEST(PairWatch, OneEyedAndBlindBodiesAreLeftAlone) {
  PairWatch watch;
  StereoFrame frame;
  watch.take(frame);
  frame.left = cv::Mat3b(120, 160, cv::Vec3b::all(80));
  watch.take(frame);
  EXPECT_EQ(watch.news() + watch.finish(), "");
}

}  // namespace
}  // namespace striate::app
