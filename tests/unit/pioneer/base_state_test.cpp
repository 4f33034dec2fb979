#include "striate/platform/pioneer/base_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace striate::pioneer {
namespace {

arcos::Sip at(int x, int y, int heading) {
  arcos::Sip sip;
  sip.x = static_cast<std::uint16_t>(x & 0x7fff);
  sip.y = static_cast<std::uint16_t>(y & 0x7fff);
  sip.heading = static_cast<std::int16_t>(heading);
  return sip;
}

BaseTracker tracker_of(const char* subclass) {
  BaseTracker tracker;
  tracker.use(*find_model(subclass));
  return tracker;
}

TEST(BaseTracker, FollowsTheCountsAcrossTheirWrap) {
  BaseTracker tracker = tracker_of("p3dx-sh");
  tracker.take(at(32700, 20, 0), {});
  EXPECT_EQ(tracker.state().odometry.pose.x_m, 0.0) << "the first packet only seeds";
  for (int i = 1; i <= 100; ++i) tracker.take(at(32700 + 50 * i, 20 - i, 0), {});
  EXPECT_NEAR(tracker.state().odometry.pose.x_m, 5.0, 1e-9);
  EXPECT_NEAR(tracker.state().odometry.pose.y_m, -0.1, 1e-9);
  for (int i = 100; i >= 0; --i) tracker.take(at(32700 + 50 * i, 20, 0), {});
  EXPECT_NEAR(tracker.state().odometry.pose.x_m, 0.0, 1e-9);
}

TEST(BaseTracker, KnowsTheCountOfTheOldController) {
  BaseTracker tracker = tracker_of("p3dx");
  tracker.take(at(0, 0, 0), {});
  tracker.take(at(1000, 0, 0), {});
  EXPECT_NEAR(tracker.state().odometry.pose.x_m, 0.485, 1e-9);
  EXPECT_EQ(find_model("p2at"), nullptr);
}

TEST(BaseTracker, HeadingWrapsAt4096Counts) {
  BaseTracker tracker = tracker_of("p3dx-sh");
  tracker.take(at(0, 0, 2040), {});
  tracker.take(at(0, 0, -2040), {});
  EXPECT_NEAR(tracker.state().odometry.pose.heading_rad, 16 * 2 * M_PI / 4096, 1e-9);
}

TEST(BaseTracker, GoesOnFromWhereItWasAfterANewConnection) {
  BaseTracker tracker = tracker_of("p3dx-sh");
  tracker.take(at(0, 0, 0), {});
  tracker.take(at(1000, 0, 1024), {});  // ahead, and then a quarter turn to the left
  tracker.seed_again();
  tracker.take(at(7, 7, 0), {});
  tracker.take(at(507, 7, 0), {});  // ahead in its new frame is to the left in ours
  EXPECT_NEAR(tracker.state().odometry.pose.x_m, 1.0, 1e-9);
  EXPECT_NEAR(tracker.state().odometry.pose.y_m, 0.5, 1e-9);
}

TEST(BaseTracker, BumpersCountOnlyWhereTheRobotHasSome) {
  BaseTracker tracker = tracker_of("p3dx-sh");
  arcos::Sip sip = at(0, 0, 0);
  sip.stall_and_bumpers = 0xfefe;  // a real robot without bumpers: the bits float
  tracker.take(sip, {});
  EXPECT_FALSE(tracker.state().bumper_front || tracker.state().bumper_rear);
  EXPECT_FALSE(tracker.state().stalled_left || tracker.state().stalled_right);
  tracker.use_bumpers(true, false);
  tracker.take(sip, {});
  EXPECT_TRUE(tracker.state().bumper_front);
  EXPECT_FALSE(tracker.state().bumper_rear);
  sip.stall_and_bumpers = 0x0100;
  tracker.take(sip, {});
  EXPECT_TRUE(tracker.state().stalled_right);
  EXPECT_FALSE(tracker.state().stalled_left);
}

TEST(BaseTracker, EveryDiscHasItsOwnTime) {
  BaseTracker tracker = tracker_of("p3dx-sh");
  arcos::Sip sip = at(0, 0, 0);
  sip.sonar = {{3, 1500}, {200, 7}};  // there is no disc 200
  tracker.take(sip, TimePoint(std::chrono::milliseconds(100)));
  sip.sonar = {{4, 5000}};
  tracker.take(sip, TimePoint(std::chrono::milliseconds(200)));
  const BaseState& state = tracker.state();
  EXPECT_DOUBLE_EQ(state.sonar[3].range_m, 1.5);
  EXPECT_EQ(state.sonar[3].stamp, TimePoint(std::chrono::milliseconds(100)));
  EXPECT_TRUE(std::isinf(state.sonar[4].range_m));
  EXPECT_EQ(state.sonar[4].stamp, TimePoint(std::chrono::milliseconds(200)));
  EXPECT_FALSE(state.sonar[5].told);
}

TEST(BaseTracker, ReckonsTheTurnWhereOldFirmwareDoesNotTellIt) {
  BaseTracker tracker = tracker_of("p3dx");
  arcos::Sip sip = at(0, 0, 0);
  sip.left_mm_s = -100;
  sip.right_mm_s = 100;
  tracker.take(sip, {});
  EXPECT_NEAR(tracker.state().odometry.turn_rad_s, 100 * 0.0056, 1e-3);
  sip.rotation_ddeg_s = 300;
  tracker.take(sip, {});
  EXPECT_NEAR(tracker.state().odometry.turn_rad_s, radians(30.0), 1e-9);
}

}  // namespace
}  // namespace striate::pioneer
