#include "striate/platform/remote/hold_reason.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/platform/ros/inbox.hpp"

namespace striate::ros {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

constexpr Duration kStale = 500ms;

template <class Message>
Message stamped(double stamp_s) {
  Message message;
  message.header.stamp = ::ros::Time(1700000000.0 + stamp_s);
  return message;
}

RosSettings known_camera() {
  RosSettings settings;
  settings.focal_px = 200.0;
  settings.baseline_m = 0.12;
  return settings;
}

/// Messages that come each 100 ms and say when they were stamped.
struct Sender {
  Inbox inbox{known_camera()};
  sensor_msgs::Image image = [] {
    sensor_msgs::Image message;
    write(cv::Mat3b(24, 32, cv::Vec3b(1, 2, 3)), message);
    return message;
  }();

  static TimePoint at(double s) { return TimePoint(from_seconds(s)); }
  void wheels(double now_s, double late_s = 0.0) {
    auto message = stamped<nav_msgs::Odometry>(now_s - late_s);
    message.pose.pose.orientation.w = 1.0;
    inbox.take(message, at(now_s));
  }
  void eyes(double now_s, double late_s = 0.0) {
    image.header = stamped<sensor_msgs::Image>(now_s - late_s).header;
    inbox.take(Eye::left, image, at(now_s));
    inbox.take(Eye::right, image, at(now_s));
  }
  void laser(double now_s) { inbox.take(stamped<sensor_msgs::LaserScan>(now_s), at(now_s)); }
  [[nodiscard]] std::string reason(double now_s) const {
    return remote::stale_sense(inbox, kStale, at(now_s));
  }
};

TEST(StaleSense, HoldsUntilImagesAndOdometryHaveCome) {
  Sender robot;
  EXPECT_EQ(robot.reason(0.0), "no odometry");
  robot.wheels(0.0);
  EXPECT_EQ(robot.reason(0.0), "no images");
  robot.eyes(0.0);
  EXPECT_EQ(robot.reason(0.0), "");
}

TEST(StaleSense, HoldsWhenOneOfThemFallsSilent) {
  Sender robot;
  robot.wheels(0.0);
  robot.eyes(0.0);
  robot.wheels(0.4);
  EXPECT_EQ(robot.reason(0.49), "");
  EXPECT_EQ(robot.reason(0.51), "no images");
  robot.eyes(0.9);
  EXPECT_EQ(robot.reason(0.91), "no odometry");
}

TEST(StaleSense, ALaserCountsOnceItHasSpoken) {
  Sender robot;
  robot.wheels(0.0);
  robot.eyes(0.0);
  robot.laser(0.0);
  robot.wheels(0.6);
  robot.eyes(0.6);
  EXPECT_EQ(robot.reason(0.6), "the laser is silent");
  robot.laser(0.65);
  EXPECT_EQ(robot.reason(0.65), "");
}

TEST(StaleSense, HoldsWhenImagesPileUpOnTheWayThoughTheyKeepComing) {
  Sender robot;
  for (int i = 0; i < 100; ++i) {
    const double now_s = 0.1 * i;
    robot.wheels(now_s);
    robot.eyes(now_s, 0.05 * i);
    if (i < 9) {
      EXPECT_EQ(robot.reason(now_s), "") << i;
    } else if (i > 11) {
      EXPECT_THAT(robot.reason(now_s), HasSubstr("late on the way")) << i;
    }
  }
}

TEST(StaleSense, AClockThatWasSetIsNoLateness) {
  Sender robot;
  for (int i = 0; i < 40; ++i) {
    const double now_s = 0.1 * i;
    const double set_back_s = i < 10 ? 0.0 : i < 20 ? 30.0 : -900.0;
    robot.wheels(now_s, set_back_s);
    robot.eyes(now_s, set_back_s);
    EXPECT_EQ(robot.reason(now_s), "") << i;
  }
}

TEST(StaleSense, OldOdometryHoldsToo) {
  Sender robot;
  robot.wheels(0.0);
  robot.eyes(0.0);
  robot.wheels(1.0, 0.9);
  robot.eyes(1.0);
  EXPECT_THAT(robot.reason(1.0), StartsWith("odometry is 0.9 s old"));
}

}  // namespace
}  // namespace striate::ros
