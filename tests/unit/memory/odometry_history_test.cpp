#include "striate/memory/short_term/odometry_history.hpp"

#include <gtest/gtest.h>

#include "tests/reference/looks.hpp"

namespace striate::memory {
namespace {

TEST(OdometryHistory, InterpolatesBetweenPoses) {
  OdometryHistory history;
  history.add(looks::at_ms(100), {1.0, 0.0, 3.1});
  history.add(looks::at_ms(200), {2.0, 1.0, -3.1});
  const Pose2 middle = history.at(looks::at_ms(150));
  EXPECT_NEAR(middle.x_m, 1.5, 1e-9);
  EXPECT_NEAR(middle.y_m, 0.5, 1e-9);
  EXPECT_NEAR(std::abs(middle.heading_rad), std::numbers::pi, 1e-6);  // the short way round
}

TEST(OdometryHistory, KeepsTheLastSecondsOnly) {
  OdometryHistory history;
  for (int i = 1; i <= 200; ++i) history.add(looks::at_ms(100 * i), {0.1 * i, 0.0, 0.0});
  EXPECT_TRUE(history.reaches(looks::at_ms(14000)));
  EXPECT_FALSE(history.reaches(looks::at_ms(13000)));
  EXPECT_NEAR(history.at(looks::at_ms(15050)).x_m, 15.05, 1e-9);
  EXPECT_NEAR(history.at(looks::at_ms(99999)).x_m, 20.0, 1e-9);
}

TEST(OdometryHistory, IgnoresAStampThatIsNotNew) {
  OdometryHistory history;
  history.add(looks::at_ms(100), {1.0, 0.0, 0.0});
  history.add(looks::at_ms(100), {9.0, 0.0, 0.0});
  EXPECT_NEAR(history.at(looks::at_ms(100)).x_m, 1.0, 1e-9);
}

}  // namespace
}  // namespace striate::memory
