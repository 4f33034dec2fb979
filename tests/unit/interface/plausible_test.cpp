#include "striate/platform/interface/plausible.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace striate {
namespace {

using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNone = std::nan("");

/// An image pair of the shipped camera.
StereoFrame good_frame(int width_px = 320, int height_px = 240) {
  StereoFrame frame;
  frame.left = cv::Mat3b(height_px, width_px);
  frame.right = cv::Mat3b(height_px, width_px);
  frame.focal_px = 406.0 * width_px / 320.0;
  frame.centre_u_px = 0.5 * (width_px - 1);
  frame.centre_v_px = 0.5 * (height_px - 1);
  frame.baseline_m = 0.12;
  return frame;
}

TEST(PlausibleFrame, TheShippedCameraOneEyeAndNoImageMayBe) {
  EXPECT_EQ(why_implausible(good_frame()), "");
  EXPECT_EQ(why_implausible(good_frame(1280, 960)), "");
  EXPECT_EQ(why_implausible(StereoFrame{}), "");
  StereoFrame one_eye = good_frame();
  one_eye.right.release();
  one_eye.baseline_m = 0.0;
  EXPECT_EQ(why_implausible(one_eye), "");
}

TEST(PlausibleFrame, AFocalLengthIsOneOfALens) {
  for (const double odd_px : {0.0, -406.0, 2.0, 40.0, 4e6, 1e300, kInfinity, kNone}) {
    StereoFrame frame = good_frame();
    frame.focal_px = odd_px;
    EXPECT_THAT(why_implausible(frame), HasSubstr("focal length")) << odd_px;
  }
  for (const double fine_px : {100.0, 250.0, 2000.0}) {
    StereoFrame frame = good_frame();
    frame.focal_px = fine_px;
    EXPECT_EQ(why_implausible(frame), "") << fine_px;
  }
}

TEST(PlausibleFrame, EveryOtherNumberOfItIsBoundedToo) {
  for (const double odd : {-1e9, 1e9, kInfinity, kNone}) {
    for (const auto number :
         {&StereoFrame::centre_u_px, &StereoFrame::centre_v_px, &StereoFrame::baseline_m}) {
      StereoFrame frame = good_frame();
      frame.*number = odd;
      EXPECT_NE(why_implausible(frame), "") << odd;
    }
    StereoFrame frame = good_frame();
    frame.head.tilt_rad = odd;
    EXPECT_THAT(why_implausible(frame), HasSubstr("tilt"));
    frame = good_frame();
    frame.head.pan_rad = odd;
    EXPECT_THAT(why_implausible(frame), HasSubstr("pan"));
  }
  StereoFrame late = good_frame();
  late.stamp = TimePoint::max();
  EXPECT_THAT(why_implausible(late), HasSubstr("time"));
}

TEST(PlausibleFrame, AnImageHasTheShapeOfAnImage) {
  EXPECT_THAT(why_implausible(good_frame(8, 8)), HasSubstr("8 x 8"));
  EXPECT_THAT(why_implausible(good_frame(16, 4096)), HasSubstr("16 x 4096"));
  StereoFrame other = good_frame();
  other.right = cv::Mat3b(120, 160);
  EXPECT_THAT(why_implausible(other), HasSubstr("the right one 160 x 120"));
}

TEST(PlausibleFrame, IsToldFromAnotherCamerasByViewAndBaseline) {
  const double view_rad = radians(43.0);
  EXPECT_EQ(why_of_another_camera(good_frame(), view_rad, 0.12), "");
  EXPECT_EQ(why_of_another_camera(good_frame(1280, 960), view_rad, 0.12), "");
  EXPECT_EQ(why_of_another_camera(good_frame(), view_rad, 0.0), "");
  EXPECT_EQ(why_of_another_camera(good_frame(), view_rad, 0.11), "");
  EXPECT_THAT(why_of_another_camera(good_frame(), radians(80.0), 0.12), HasSubstr("80 deg"));
  EXPECT_THAT(why_of_another_camera(good_frame(), view_rad, 0.3), HasSubstr("0.3 m"));
  StereoFrame frame = good_frame();
  frame.focal_px = kNone;
  EXPECT_NE(why_of_another_camera(frame, view_rad, 0.12), "");
}

TEST(PlausibleSenses, WhatABodyFeelsIsFiniteAndNotFarOut) {
  Senses good;
  good.sonar.readings = {{0.1, kInfinity}, {0.2, kNone}, {0.3, 1.0}};
  EXPECT_EQ(why_implausible(good), "");
  for (const double odd : {-1e9, 1e9, kInfinity, kNone}) {
    for (const auto number : {&Pose2::x_m, &Pose2::y_m, &Pose2::heading_rad}) {
      Senses senses = good;
      senses.odometry.pose.*number = odd;
      EXPECT_THAT(why_implausible(senses), HasSubstr("odometry")) << odd;
    }
    Senses senses = good;
    senses.odometry.turn_rad_s = odd;
    EXPECT_THAT(why_implausible(senses), HasSubstr("turn"));
    senses = good;
    senses.battery_v = odd;
    EXPECT_THAT(why_implausible(senses), HasSubstr("battery"));
  }
  good.laser.readings = {{kNone, 1.0}};
  EXPECT_THAT(why_implausible(good), HasSubstr("laser"));
  good.laser.readings = {{0.0, -1.0}};
  EXPECT_THAT(why_implausible(good), HasSubstr("laser"));
  good.laser.readings.clear();
  good.odometry.stamp = TimePoint::min();
  EXPECT_THAT(why_implausible(good), HasSubstr("time"));
}

TEST(PlausibleRobot, HasASizeAMountAndACycle) {
  EXPECT_EQ(why_implausible(RobotDescription{}), "");
  for (const double odd : {-1.0, 1e9, kNone}) {
    for (const auto number :
         {&RobotDescription::front_m, &RobotDescription::rear_m, &RobotDescription::half_width_m,
          &RobotDescription::camera_height_m, &RobotDescription::max_pan_rad,
          &RobotDescription::view_rad, &RobotDescription::max_acceleration_m_s2}) {
      RobotDescription robot;
      robot.*number = odd;
      EXPECT_NE(why_implausible(robot), "") << odd;
    }
  }
  RobotDescription robot;
  robot.cycle = Duration(0);
  EXPECT_THAT(why_implausible(robot), HasSubstr("cycle"));
}

}  // namespace
}  // namespace striate
