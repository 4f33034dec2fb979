#include "memory/trail.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace striate {
namespace {

TEST(Trail, KeepsTheStartAndEveryStep) {
  Trail trail;
  for (int i = 0; i <= 100; ++i) trail.walk({0.05 * i, 0.0, 0.0});
  EXPECT_EQ(trail.start().x_m, 0.0);
  EXPECT_NEAR(static_cast<double>(trail.count()), 5.0 / Trail::kFirstStep_m, 2.0);
  EXPECT_NEAR(trail.at(trail.count() - 1).x_m, 5.0, Trail::kFirstStep_m);
}

TEST(Trail, StandingAddsNothing) {
  Trail trail;
  for (int i = 0; i < 100; ++i) trail.walk({1.0, 2.0, 0.1 * i});
  EXPECT_EQ(trail.count(), 1U);
}

TEST(Trail, IsThinnedInsteadOfEnding) {
  Trail trail;
  for (int i = 0; i <= 10000; ++i) trail.walk({0.1 * i, 0.0, 0.0});  // a kilometre
  EXPECT_LE(trail.count(), Trail::kCapacity);
  EXPECT_EQ(trail.at(0).x_m, 0.0);
  EXPECT_NEAR(trail.at(trail.count() - 1).x_m, 1000.0, trail.step_m());
  for (std::size_t i = 1; i < trail.count(); ++i) {
    EXPECT_LT(trail.at(i).x_m - trail.at(i - 1).x_m, 2.0 * trail.step_m());
  }
}

TEST(Trail, TellsWhatIsNear) {
  Trail trail;
  EXPECT_TRUE(std::isinf(trail.distance_m({0.0, 0.0})));
  for (int i = 0; i <= 40; ++i) trail.walk({0.25 * i, 0.0, 0.0});
  EXPECT_NEAR(trail.at(trail.nearest({4.1, 1.0})).x_m, 4.0, 0.13);
  EXPECT_NEAR(trail.distance_m({4.0, 1.0}), 1.0, 0.02);
  EXPECT_GT(trail.distance_m({10.0, 0.0}, 8), 1.7);
}

}  // namespace
}  // namespace striate
