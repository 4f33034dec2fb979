#include "striate/memory/short_term/trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace striate::memory {
namespace {

TEST(Trajectory, KeepsTheStartAndEveryStep) {
  Trajectory trajectory;
  for (int i = 0; i <= 100; ++i) trajectory.walk({0.05 * i, 0.0, 0.0});
  EXPECT_EQ(trajectory.start().x_m, 0.0);
  EXPECT_NEAR(static_cast<double>(trajectory.count()), 5.0 / Trajectory::kFirstStep_m, 2.0);
  EXPECT_NEAR(trajectory.at(trajectory.count() - 1).x_m, 5.0, Trajectory::kFirstStep_m);
}

TEST(Trajectory, StandingAddsNothing) {
  Trajectory trajectory;
  for (int i = 0; i < 100; ++i) trajectory.walk({1.0, 2.0, 0.1 * i});
  EXPECT_EQ(trajectory.count(), 1U);
}

TEST(Trajectory, IsThinnedInsteadOfEnding) {
  Trajectory trajectory;
  for (int i = 0; i <= 10000; ++i) trajectory.walk({0.1 * i, 0.0, 0.0});  // a kilometre
  EXPECT_LE(trajectory.count(), Trajectory::kCapacity);
  EXPECT_EQ(trajectory.at(0).x_m, 0.0);
  EXPECT_NEAR(trajectory.at(trajectory.count() - 1).x_m, 1000.0, trajectory.step_m());
  for (std::size_t i = 1; i < trajectory.count(); ++i) {
    EXPECT_LT(trajectory.at(i).x_m - trajectory.at(i - 1).x_m, 2.0 * trajectory.step_m());
  }
}

TEST(Trajectory, TellsWhatIsNear) {
  Trajectory trajectory;
  EXPECT_TRUE(std::isinf(trajectory.distance_m({0.0, 0.0})));
  for (int i = 0; i <= 40; ++i) trajectory.walk({0.25 * i, 0.0, 0.0});
  EXPECT_NEAR(trajectory.at(trajectory.nearest({4.1, 1.0})).x_m, 4.0, 0.13);
  EXPECT_NEAR(trajectory.distance_m({4.0, 1.0}), 1.0, 0.02);
  EXPECT_GT(trajectory.distance_m({10.0, 0.0}, 8), 1.7);
}

}  // namespace
}  // namespace striate::memory
