#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "tests/reference/scattered_pair.hpp"
#include "tests/reference/write_motion_jpeg.hpp"
#include "tests/scenarios/striate_process.hpp"

/// The program loads OpenCV's readers of images and videos when it needs them.
namespace striate::scenarios {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(LateOpencv, TheProgramStartsWithoutTheLibrariesThatReadImages) {
  const Ended loaded = bash("LD_TRACE_LOADED_OBJECTS=1 \"$striate\"");
  EXPECT_THAT(loaded.out, HasSubstr("libopencv_core"));
  EXPECT_THAT(loaded.out, Not(HasSubstr("libopencv_imgcodecs")));
  EXPECT_THAT(loaded.out, Not(HasSubstr("libopencv_videoio")));
  EXPECT_THAT(loaded.out, Not(HasSubstr("libopencv_ximgproc")));
}

TEST(LateOpencv, AVideoIsOpenedAndRead) {
  const TemporaryFolder folder;
  const reference::EyeImages eyes = reference::scattered_pair(4, 60.0, 6.0, {320, 240});
  cv::Mat both;
  cv::hconcat(eyes.left, eyes.right, both);
  cv::cvtColor(both, both, cv::COLOR_GRAY2BGR);
  reference::write_motion_jpeg(folder / "d.avi", std::vector<cv::Mat>(20, both), 20);
  const std::string robot = folder.write(
      "robot.yaml", "pioneer:\n  devices: {base: \"tcp://127.0.0.1:1\", camera: \"video:" +
                        (folder / "d.avi") + "\"}\n");
  const Ended ended = striate({"doctor", "--robot", robot});
  EXPECT_THAT(ended.out, HasSubstr("eyes of")) << ended.err;
}

}  // namespace
}  // namespace striate::scenarios
