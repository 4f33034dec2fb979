#include "striate/platform/pioneer/turret/head_history.hpp"

#include <gtest/gtest.h>

namespace striate::pioneer {
namespace {

TimePoint at_ms(int ms) {
  return TimePoint(std::chrono::milliseconds(ms));
}

TEST(HeadHistory, GivesTheHeadOfAMomentBetweenTwoReadings) {
  HeadHistory trajectory;
  EXPECT_EQ(trajectory.at(at_ms(5)).pan_rad, 0.0) << "nothing is known yet";
  for (int i = 1; i <= 300; ++i) trajectory.add(at_ms(10 * i), {0.01 * i, -0.02 * i});
  EXPECT_NEAR(trajectory.at(at_ms(2905)).pan_rad, 2.905, 1e-9);
  EXPECT_NEAR(trajectory.at(at_ms(2905)).tilt_rad, -5.81, 1e-9);
  EXPECT_NEAR(trajectory.at(at_ms(9000)).pan_rad, 3.0, 1e-9) << "the newest";
  EXPECT_NEAR(trajectory.at(at_ms(20)).pan_rad, 1.73, 1e-9) << "the oldest that is kept";
}

TEST(HeadHistory, AReadingThatIsNotNewerCountsOnce) {
  HeadHistory trajectory;
  trajectory.add(at_ms(10), {0.1, 0.0});
  trajectory.add(at_ms(10), {0.9, 0.0});
  EXPECT_NEAR(trajectory.at(at_ms(10)).pan_rad, 0.1, 1e-9);
}

}  // namespace
}  // namespace striate::pioneer
