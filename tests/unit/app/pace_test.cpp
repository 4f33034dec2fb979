#include "striate/app/pace.hpp"

#include <gtest/gtest.h>

namespace striate::app {
namespace {

using namespace std::chrono_literals;

TEST(Pace, HoldsCyclesBackToTheClockOnTheWallAndHurriesNone) {
  Pace pace(1.0);
  const Pace::Steady::time_point began{};
  EXPECT_EQ(pace.due(TimePoint(5s), began), began);
  EXPECT_EQ(pace.due(TimePoint(5100ms), began + 20ms), began + 100ms);
  // One that was late by 50 ms is due at once, and the next one 100 ms behind it.
  EXPECT_EQ(pace.due(TimePoint(5200ms), began + 250ms), began + 250ms);
  EXPECT_EQ(pace.due(TimePoint(5300ms), began + 260ms), began + 350ms);
}

TEST(Pace, OfTwiceTheSpeedWaitsHalfAsLongAndOfNoneNotAtAll) {
  const Pace::Steady::time_point began{};
  Pace twice(2.0);
  (void)twice.due(TimePoint(1s), began);
  EXPECT_EQ(twice.due(TimePoint(2s), began), began + 500ms);
  Pace free(0.0);
  (void)free.due(TimePoint(1s), began);
  EXPECT_EQ(free.due(TimePoint(9s), began + 1ms), began + 1ms);
}

}  // namespace
}  // namespace striate::app
