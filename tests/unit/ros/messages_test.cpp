#include "striate/platform/ros/messages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace striate::ros {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Messages, OdometryComesBackAsItWent) {
  Odometry sent;
  sent.pose = {1.5, -2.25, -2.9};
  sent.forward_m_s = 0.4;
  sent.turn_rad_s = -0.3;
  nav_msgs::Odometry message;
  write(sent, message);
  Odometry read_back;
  ASSERT_TRUE(read(message, read_back));
  EXPECT_NEAR(read_back.pose.x_m, 1.5, 1e-12);
  EXPECT_NEAR(read_back.pose.y_m, -2.25, 1e-12);
  EXPECT_NEAR(read_back.pose.heading_rad, -2.9, 1e-12);
  EXPECT_EQ(read_back.forward_m_s, 0.4);
  EXPECT_EQ(read_back.turn_rad_s, -0.3);
  message.twist.twist.linear.x = std::nan("");
  EXPECT_FALSE(read(message, read_back));
}

TEST(Messages, TheNearestEchoOfEachDegreeGoesIntoAScan) {
  RangeScan sent;
  sent.readings = {{0.0, 2.0}, {0.001, 1.5}, {0.5, kInfinity}, {-3.1, 0.7}};
  sensor_msgs::LaserScan message;
  write(sent, message);
  RangeScan back;
  read(message, 0.0, back);
  ASSERT_EQ(back.readings.size(), 3u) << "where nobody looked, nothing is said";
  EXPECT_NEAR(back.readings[0].bearing_rad, -3.1, 0.01);
  EXPECT_NEAR(back.readings[0].distance_m, 0.7, 1e-6);
  EXPECT_NEAR(back.readings[1].distance_m, 1.5, 1e-6);
  EXPECT_TRUE(std::isinf(back.readings[2].distance_m));
}

TEST(Messages, AScanIsSeenFromTheAxle) {
  sensor_msgs::LaserScan message;
  message.angle_min = static_cast<float>(kPi / 2.0);
  message.angle_increment = 0.1F;
  message.range_max = 10.0F;
  message.ranges = {3.0F, std::nanf("")};
  RangeScan scan;
  read(message, 4.0, scan);
  ASSERT_EQ(scan.readings.size(), 1u);
  EXPECT_NEAR(scan.readings[0].distance_m, 5.0, 1e-6);
  EXPECT_NEAR(scan.readings[0].bearing_rad, std::atan2(3.0, 4.0), 1e-6);
}

TEST(Messages, ACameraComesBackAsItWentAndFitsSmallerImages) {
  StereoFrame sent;
  sent.left = cv::Mat3b(240, 320);
  sent.right = sent.left;
  sent.focal_px = 406.0;
  sent.centre_u_px = 160.5;
  sent.centre_v_px = 118.0;
  sent.baseline_m = 0.12;
  sensor_msgs::CameraInfo left;
  sensor_msgs::CameraInfo right;
  write(sent, false, left);
  write(sent, true, right);
  remote::CameraModel model(0.0, 0.0);
  model.set_left(eye_info_of(left));
  EXPECT_FALSE(model.known());
  model.set_right(eye_info_of(right));
  ASSERT_TRUE(model.known());
  StereoFrame back;
  back.left = cv::Mat3b(240, 320);
  model.fill(back);
  EXPECT_NEAR(back.focal_px, 406.0, 1e-9);
  EXPECT_NEAR(back.centre_u_px, 160.5, 1e-9);
  EXPECT_NEAR(back.centre_v_px, 118.0, 1e-9);
  EXPECT_NEAR(back.baseline_m, 0.12, 1e-9);
  back.left = cv::Mat3b(120, 160);
  model.fill(back);
  EXPECT_NEAR(back.focal_px, 203.0, 1e-9);
  EXPECT_NEAR(back.centre_u_px, 80.0, 1e-9);

  remote::CameraModel crossed(0.0, 0.0);
  crossed.set_left(eye_info_of(right));
  crossed.set_right(eye_info_of(left));
  EXPECT_FALSE(crossed.known());
  EXPECT_TRUE(crossed.swapped());
}

}  // namespace
}  // namespace striate::ros
