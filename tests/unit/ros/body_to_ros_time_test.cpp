#include "striate/platform/ros/body_to_ros_time.hpp"

#include <gtest/gtest.h>

namespace striate::ros {
namespace {

using namespace std::chrono_literals;

/// Of a clock that counts from 1970.
std::int64_t since_1970(Duration since) {
  return 1'700'000'000'000'000'000 + since.count();
}

TEST(BodyToRosTime, KeepsDistancesAndCatchesUpWhereTheBodyIsSlow) {
  BodyToRosTime time;
  time.tie(TimePoint(1s), since_1970(0s));
  EXPECT_EQ(time.ros_ns(TimePoint(900ms)), since_1970(-100ms));
  time.tie(TimePoint(1100ms), since_1970(120ms));  // 20 ms: what a scheduler makes
  EXPECT_EQ(time.ros_ns(TimePoint(1100ms)), since_1970(100ms));
  time.tie(TimePoint(1200ms), since_1970(300ms));
  EXPECT_EQ(time.ros_ns(TimePoint(1200ms)), since_1970(300ms));
}

}  // namespace
}  // namespace striate::ros
