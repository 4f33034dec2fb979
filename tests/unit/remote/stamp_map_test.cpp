#include "striate/platform/remote/stamp_map.hpp"

#include <gtest/gtest.h>

namespace striate::remote {
namespace {

using namespace std::chrono_literals;
constexpr std::int64_t kFar_ns = 1'700'000'000'000'000'000;

std::int64_t stamp(Duration since) {
  return kFar_ns + since.count();
}

/// Learns from a message and says when it was stamped.
TimePoint heard(StampMap& map, std::int64_t stamp_ns, TimePoint arrived,
                Stream stream = Stream::odometry) {
  map.learn(stream, stamp_ns, arrived);
  return map.to_body(stamp_ns, arrived);
}

TEST(StampMap, TheMessageLeastUnderWayTellsTheClocksApart) {
  StampMap map;
  EXPECT_EQ(heard(map, stamp(0ms), TimePoint(1050ms)), TimePoint(1050ms));
  EXPECT_EQ(heard(map, stamp(100ms), TimePoint(1110ms)), TimePoint(1110ms));
  // This one was 40 ms longer under way.
  const TimePoint late = heard(map, stamp(200ms), TimePoint(1250ms));
  EXPECT_NEAR(to_seconds(late), 1.210, 0.001);
}

TEST(StampMap, NoStampIsInTheFuture) {
  StampMap map;
  for (int i = 0; i < 200; ++i) {
    const TimePoint arrived(i * 100ms + (i * 37 % 60) * 1ms);
    EXPECT_LE(heard(map, stamp(i * 100ms), arrived), arrived);
  }
}

TEST(StampMap, FollowsAClockThatDriftsAway) {
  StampMap map;
  double age_s = 0.0;
  for (int i = 0; i < 36000; ++i) {  // one hour, the sender 100 ppm too slow
    const TimePoint arrived(i * 100'010us);
    age_s = to_seconds(arrived - heard(map, stamp(i * 100ms), arrived));
  }
  EXPECT_LT(age_s, 0.01);
}

TEST(StampMap, BeginsAnewWhenTheClockWasSet) {
  StampMap map;
  heard(map, stamp(0s), TimePoint(1s));
  EXPECT_EQ(heard(map, stamp(-50s), TimePoint(2s)), TimePoint(2s));
  EXPECT_EQ(heard(map, stamp(900s), TimePoint(3s)), TimePoint(3s));
}

TEST(StampMap, WhatPilesUpOnTheWayIsOldAndStaysOld) {
  StampMap map;
  heard(map, stamp(0s), TimePoint(1s));
  for (int i = 1; i < 100; ++i) {  // each message is 100 ms later than the one before it
    const TimePoint arrived(1s + i * 200ms);
    const double age_s = to_seconds(arrived - heard(map, stamp(i * 100ms), arrived));
    ASSERT_NEAR(age_s, 0.1 * i, 0.01);
  }
  // A minute later on, still ten seconds behind.
  for (int i = 100; i < 700; ++i) {
    const TimePoint arrived(11s + i * 100ms);
    const double age_s = to_seconds(arrived - heard(map, stamp(i * 100ms), arrived));
    ASSERT_NEAR(age_s, 10.0, 0.05);
  }
}

TEST(StampMap, ATopicIsLateBesideAnother) {
  StampMap map;
  for (int i = 0; i < 50; ++i) {
    const TimePoint now(1s + i * 100ms);
    heard(map, stamp(i * 100ms), now);
    const TimePoint image = heard(map, stamp(i * 100ms - 3s), now, Stream::left);
    EXPECT_NEAR(to_seconds(now - image), 3.0, 0.01);
  }
}

TEST(StampMap, WithoutAStampTheArrivalCounts) {
  StampMap map;
  EXPECT_EQ(heard(map, 0, TimePoint(7s)), TimePoint(7s));
}

TEST(StampMap, TheSendersClockIsToldBackAndNeverAhead) {
  StampMap map;
  EXPECT_FALSE(map.to_sender(TimePoint(1s)));
  heard(map, stamp(0s), TimePoint(1s));         // under way for a while
  heard(map, stamp(100ms), TimePoint(1050ms));  // the quickest
  heard(map, stamp(200ms), TimePoint(1500ms));
  ASSERT_TRUE(map.to_sender(TimePoint(2050ms)));
  EXPECT_NEAR(static_cast<double>(*map.to_sender(TimePoint(2050ms)) - stamp(1100ms)), 0.0, 1e6);
}

}  // namespace
}  // namespace striate::remote
