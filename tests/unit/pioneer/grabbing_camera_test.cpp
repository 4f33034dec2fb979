#include <gtest/gtest.h>

#include <opencv2/videoio.hpp>
#include <thread>
#include <vector>

#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/camera/bumblebee_image.hpp"
#include "striate/platform/pioneer/camera/make_stereo_camera.hpp"
#include "striate/platform/pioneer/camera/stereo_camera.hpp"
#include "striate/platform/pioneer/steady_clock.hpp"
#include "tests/reference/temporary_folder.hpp"
#include "tests/reference/write_motion_jpeg.hpp"

namespace striate::pioneer {
namespace {

using namespace std::chrono_literals;

/// Both eyes side by side: dark left, bright right; each image a little brighter.
void write_video(const std::string& file, int pictures) {
  std::vector<cv::Mat> video;
  for (int i = 0; i < pictures; ++i) {
    cv::Mat3b image(240, 640);
    image.colRange(0, 320).setTo(cv::Scalar::all(40 + i));
    image.colRange(320, 640).setTo(cv::Scalar::all(160 + i));
    video.push_back(image);
  }
  reference::write_motion_jpeg(file, video, 20);
}

double brightness(const cv::Mat3b& image) {
  return cv::mean(image)[1];
}

StereoFrame first_image(const StereoCamera& camera) {
  const auto end = std::chrono::steady_clock::now() + 5s;
  StereoFrame frame = camera.newest();
  while (frame.left.empty() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(5ms);
    frame = camera.newest();
  }
  return frame;
}

TEST(GrabbingCamera, PlaysAVideoThatShowsBothEyesSideBySide) {
  const reference::TemporaryFolder folder;
  write_video(folder / "drive.avi", 30);
  const SteadyClock clock;
  StereoCameraSettings settings;
  settings.width_px = 160;
  const auto camera = make_stereo_camera("video:" + (folder / "drive.avi"), settings, clock);
  const StereoFrame first = first_image(*camera);
  ASSERT_EQ(first.left.size(), cv::Size(160, 120));
  EXPECT_NEAR(brightness(first.left), 40.0, 15.0);
  EXPECT_NEAR(brightness(first.right), 160.0, 15.0);
  EXPECT_NEAR(first.focal_px, 80.0 / std::tan(radians(21.5)), 1e-6);
  EXPECT_NEAR(first.baseline_m, 0.12, 1e-9);
  std::this_thread::sleep_for(500ms);
  const StereoFrame later = camera->newest();
  EXPECT_GT(brightness(later.left), brightness(first.left) + 2.0) << "it goes on at its own pace";
  EXPECT_LT(brightness(later.left), brightness(first.left) + 29.0);
  EXPECT_GT(later.stamp, first.stamp);
  EXPECT_NEAR(to_seconds(clock.now() - later.stamp), settings.latency_s, 0.3);
}

TEST(GrabbingCamera, ExchangesTheEyesWhereItIsTold) {
  const reference::TemporaryFolder folder;
  write_video(folder / "drive.avi", 10);
  const SteadyClock clock;
  StereoCameraSettings settings;
  settings.swap = true;
  const auto camera = make_stereo_camera("video:" + (folder / "drive.avi"), settings, clock);
  const StereoFrame frame = first_image(*camera);
  ASSERT_FALSE(frame.left.empty());
  EXPECT_GT(brightness(frame.left), brightness(frame.right) + 80.0);
}

TEST(GrabbingCamera, TakesOneVideoForEachEye) {
  const reference::TemporaryFolder folder;
  write_video(folder / "left.avi", 10);
  write_video(folder / "right.avi", 10);
  const SteadyClock clock;
  const auto camera = make_stereo_camera(
      "video:" + (folder / "left.avi") + "," + (folder / "right.avi"), {}, clock);
  const StereoFrame frame = first_image(*camera);
  EXPECT_EQ(frame.left.size(), cv::Size(320, 120));
  EXPECT_NEAR(brightness(frame.left), brightness(frame.right), 5.0);
}

TEST(GrabbingCamera, TellsWhyNoImageComes) {
  const SteadyClock clock;
  const auto camera = make_stereo_camera("video:/no/such/video.avi", {}, clock);
  const auto end = std::chrono::steady_clock::now() + 2s;
  while (camera->trouble().empty() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_NE(camera->trouble().find("is not there"), std::string::npos);
  EXPECT_THROW((void)make_stereo_camera("video:", {}, clock), UserError);
  EXPECT_THROW((void)make_stereo_camera("eyes", {}, clock), UserError);
  StereoCameraSettings settings;
  settings.calibration = "/no/such/file.yaml";
  EXPECT_THROW((void)make_stereo_camera("video:/dev/video0", settings, clock), UserError);
}

/// A byte of each eye in turn, right first; colours G R over B G.
std::vector<std::uint8_t> bumblebee_bytes(cv::Size size, const cv::Vec3b& left,
                                          const cv::Vec3b& right) {
  std::vector<std::uint8_t> raw;
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const int colour = (v + u) % 2 == 0 ? 1 : (v % 2 == 0 ? 2 : 0);
      raw.push_back(right[colour]);
      raw.push_back(left[colour]);
    }
  }
  return raw;
}

TEST(Bumblebee, IsTakenApartIntoTwoImagesInColour) {
  const cv::Size size(16, 12);
  const cv::Vec3b left(10, 100, 200);
  const cv::Vec3b right(90, 60, 30);
  cv::Mat3b seen_left;
  cv::Mat3b seen_right;
  const auto raw = bumblebee_bytes(size, left, right);
  ASSERT_TRUE(split_bumblebee(raw, size, seen_left, seen_right));
  for (int v = 2; v < size.height - 2; ++v) {
    for (int u = 2; u < size.width - 2; ++u) {
      ASSERT_EQ(seen_left(v, u), left);
      ASSERT_EQ(seen_right(v, u), right);
    }
  }
  EXPECT_FALSE(split_bumblebee(std::span(raw).first(100), size, seen_left, seen_right));
}

}  // namespace
}  // namespace striate::pioneer
