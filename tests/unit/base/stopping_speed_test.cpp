#include "striate/base/stopping_speed.hpp"

#include <gtest/gtest.h>

namespace striate {
namespace {

/// Drives on for the latency and then brakes, in steps of 0.1 ms.
double way_of_a_stop(double speed, double deceleration, double latency_s) {
  constexpr double kStep_s = 1e-4;
  double way = 0.0;
  for (double t = 0.0; speed > 0.0; t += kStep_s) {
    if (t >= latency_s) speed -= deceleration * kStep_s;
    way += speed * kStep_s;
  }
  return way;
}

TEST(StoppingSpeed, StandsJustWithinTheWay) {
  for (const double way_m : {0.05, 0.4, 3.0}) {
    for (const double latency_s : {0.0, 0.15, 0.35}) {
      const double speed = stopping_speed(way_m, 0.5, latency_s);
      EXPECT_NEAR(way_of_a_stop(speed, 0.5, latency_s), way_m, 0.002) << way_m << " " << latency_s;
      EXPECT_NEAR(stopping_way(speed, 0.5, latency_s), way_m, 1e-12);
    }
  }
}

TEST(StoppingSpeed, IsTheSameInMillimetres) {
  EXPECT_NEAR(stopping_speed(740.0, 300.0, 0.15), 1000.0 * stopping_speed(0.74, 0.3, 0.15), 1e-9);
}

TEST(StoppingSpeed, WithoutRoomIsZero) {
  EXPECT_EQ(stopping_speed(0.0, 0.5, 0.15), 0.0);
  EXPECT_EQ(stopping_speed(-0.2, 0.5, 0.15), 0.0);
}

TEST(StoppingWay, IsTheSameBackwards) {
  EXPECT_EQ(stopping_way(-0.4, 0.5, 0.3), stopping_way(0.4, 0.5, 0.3));
}

}  // namespace
}  // namespace striate
