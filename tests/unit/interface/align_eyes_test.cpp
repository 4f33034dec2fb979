#include "striate/platform/interface/align_eyes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace striate {
namespace {

/// A smooth picture of a function of the ray, seen through any lens.
cv::Mat3b seen_by(double focal_px, double centre_u_px, double centre_v_px) {
  cv::Mat3b image(120, 160);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double x = (u - centre_u_px) / focal_px;
      const double y = (v - centre_v_px) / focal_px;
      const double value = 128.0 + 60.0 * std::sin(40.0 * x) + 60.0 * std::cos(35.0 * y);
      image(v, u) = cv::Vec3b::all(cv::saturate_cast<uchar>(value));
    }
  }
  return image;
}

StereoFrame frame_of(const RightEye& right) {
  StereoFrame frame;
  frame.focal_px = 200.0;
  frame.centre_u_px = 79.5;
  frame.centre_v_px = 59.5;
  frame.baseline_m = 0.12;
  frame.left = seen_by(frame.focal_px, frame.centre_u_px, frame.centre_v_px);
  frame.right = seen_by(right.focal_px > 0.0 ? right.focal_px : frame.focal_px, right.centre_u_px,
                        right.centre_v_px);
  return frame;
}

// What is endlessly far looks the same to both eyes once they have the same lens.
TEST(AlignEyes, WhatIsFarAwayHasNoDisparityAfterwards) {
  for (const RightEye& right :
       {RightEye{200.0, 95.0, 59.5}, RightEye{200.0, 66.25, 59.5}, RightEye{0.0, 79.9, 59.5},
        RightEye{200.0, 79.5, 63.0}, RightEye{206.0, 85.0, 57.0}}) {
    StereoFrame frame = frame_of(right);
    align_eyes(frame, right);
    const cv::Rect inside(24, 12, 112, 96);
    EXPECT_LT(cv::norm(frame.left(inside), frame.right(inside), cv::NORM_INF), 6.0)
        << right.focal_px << ", " << right.centre_u_px << ", " << right.centre_v_px;
  }
}

TEST(AlignEyes, EyesOfOneLensAndFramesOfOneEyeAreLeftAsTheyAre) {
  const RightEye same{200.0, 79.505, 59.5};
  StereoFrame frame = frame_of(same);
  const cv::Mat3b before = frame.right;
  align_eyes(frame, same);
  EXPECT_EQ(frame.right.data, before.data) << "not even copied";
  frame.right.release();
  align_eyes(frame, {200.0, 90.0, 59.5});
  EXPECT_TRUE(frame.right.empty());
}

TEST(AlignEyes, WhatCannotBeOnePairIsSaid) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const RightEye& right : {RightEye{400.0, 79.5, 59.5}, RightEye{200.0, none, 59.5},
                                RightEye{200.0, 500.0, 59.5}, RightEye{200.0, 79.5, -1e9}}) {
    StereoFrame frame = frame_of({});
    EXPECT_THROW(align_eyes(frame, right), std::runtime_error);
  }
}

}  // namespace
}  // namespace striate
