#include "striate/platform/pioneer/camera/network_camera.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace striate::pioneer {
namespace {

using testing::HasSubstr;

StereoFrame sent_frame(double focal_px = 50.75, double baseline_m = 0.12) {
  StereoFrame frame;
  frame.left = cv::Mat3b(30, 40, cv::Vec3b(1, 2, 3));
  frame.right = cv::Mat3b(30, 40, cv::Vec3b(4, 5, 6));
  frame.focal_px = focal_px;
  frame.centre_u_px = 19.5;
  frame.centre_v_px = 14.5;
  frame.baseline_m = baseline_m;
  return frame;
}

class ImagesOfALine : public testing::Test {
 protected:
  ImagesOfALine() { line_.line_up(now_ + std::chrono::milliseconds(100)); }
  void send(StereoFrame frame) {
    now_ += std::chrono::milliseconds(100);
    frame.stamp = now_;
    line_.receive(image_stream::encode(frame, ++number_), now_);
  }
  StreamDevice line_{StereoCameraSettings{}};
  TimePoint now_;
  std::uint32_t number_ = 0;
};

TEST_F(ImagesOfALine, AFrameOfAnotherCameraIsRefusedAndTheLastGoodOneStays) {
  send(sent_frame());
  EXPECT_EQ(line_.refused(), "");
  const TimePoint good = line_.newest().stamp;
  EXPECT_EQ(good, now_);
  // 2 px rolled on for 0.6 m and aborted the program, 4e6 px drove on at 0.65 m/s.
  for (const double focal_px : {0.25, 2.0, 20.0, 200.0, 4e6}) {
    send(sent_frame(focal_px));
    EXPECT_THAT(line_.refused(), HasSubstr("focal length")) << focal_px;
    EXPECT_EQ(line_.newest().stamp, good) << focal_px;
  }
  send(sent_frame(50.75, 0.4));
  EXPECT_THAT(line_.refused(), HasSubstr("pioneer.camera.baseline"));
  EXPECT_EQ(line_.newest().stamp, good);
  send(sent_frame());
  EXPECT_EQ(line_.refused(), "");
  EXPECT_EQ(line_.newest().stamp, now_);
}

TEST_F(ImagesOfALine, APrincipalPointFarOutsideOfTheImageIsRefused) {
  StereoFrame frame = sent_frame();
  frame.centre_v_px = 4e6;
  send(frame);
  EXPECT_THAT(line_.refused(), HasSubstr("principal point"));
  EXPECT_TRUE(line_.newest().left.empty());
}

}  // namespace
}  // namespace striate::pioneer
