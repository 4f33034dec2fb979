#include "striate/platform/remote/camera_model.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace striate::remote {
namespace {

EyeInfo eye(double focal_px, double centre_u_px, double baseline_m = 0.0) {
  EyeInfo info;
  info.width_px = 320;
  info.projection = {focal_px, 0.0,      centre_u_px, -focal_px * baseline_m,
                     0.0,      focal_px, 119.5,       0.0,
                     0.0,      0.0,      1.0,         0.0};
  return info;
}

/// The column of a white bar, or -1.
int bar_of(const cv::Mat3b& image) {
  int best = -1;
  int most = 100;
  for (int u = 0; u < image.cols; ++u) {
    const int value = image(image.rows / 2, u)[0];
    if (value <= most) continue;
    most = value;
    best = u;
  }
  return best;
}

StereoFrame bar_at(int left_px, int right_px, int width_px = 320) {
  StereoFrame frame;
  frame.left = cv::Mat3b(240 * width_px / 320, width_px, cv::Vec3b(0, 0, 0));
  frame.right = frame.left.clone();
  frame.left.col(left_px).setTo(cv::Scalar::all(255));
  frame.right.col(right_px).setTo(cv::Scalar::all(255));
  return frame;
}

TEST(CameraModel, PrincipalPointsThatDifferMoveTheRightImage) {
  for (const double apart_px : {31.0, -12.0, 0.0}) {
    CameraModel camera(0.0, 0.0);
    camera.set_left(eye(300.0, 150.0));
    camera.set_right(eye(300.0, 150.0 + apart_px, 0.1));
    StereoFrame frame = bar_at(200, 185 + static_cast<int>(apart_px));
    camera.fill(frame);
    EXPECT_DOUBLE_EQ(frame.centre_u_px, 150.0);
    EXPECT_NEAR(frame.baseline_m, 0.1, 1e-12);
    EXPECT_EQ(bar_of(frame.left) - bar_of(frame.right), 15) << apart_px;  // 2 m: f b / 15
  }
}

TEST(CameraModel, InSmallerImagesThePrincipalPointsLieNearer) {
  CameraModel camera(0.0, 0.0);
  camera.set_left(eye(300.0, 150.0));
  camera.set_right(eye(300.0, 170.0, 0.1));
  StereoFrame frame = bar_at(100, 102, 160);
  camera.fill(frame);
  EXPECT_EQ(bar_of(frame.left) - bar_of(frame.right), 8);
}

TEST(CameraModel, AFocalLengthByHandIsThatOfBothEyes) {
  CameraModel camera(320.0, 0.0);
  camera.set_left(eye(300.0, 150.0));
  camera.set_right(eye(300.0, 150.0, 0.1));
  StereoFrame frame = bar_at(200, 185);
  const auto* before = frame.right.data;
  camera.fill(frame);
  EXPECT_EQ(frame.right.data, before);
}

TEST(CameraModel, EyesThatCannotBeOnePairAreRefused) {
  CameraModel camera(0.0, 0.0);
  camera.set_left(eye(300.0, 150.0));
  camera.set_right(eye(900.0, 150.0, 0.1));
  StereoFrame frame = bar_at(200, 185);
  EXPECT_THROW(camera.fill(frame), std::runtime_error);
}

}  // namespace
}  // namespace striate::remote
