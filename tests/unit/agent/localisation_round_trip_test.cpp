#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/reference/localisation_trips.hpp"

namespace striate::agent {
namespace {

using reference::TripDriver;
using reference::TripResult;
using reference::TripSettings;

constexpr std::uint64_t kSeeds = 20;

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// The line of the project's goal: after 120 m out and back, at most a fifth of the error of
/// odometry alone; on further trips no more.
TEST(LocalisationRoundTrip, MemoryLeavesAtMostAFifthOfTheErrorOfOdometry) {
  std::vector<double> shares[3], errors_m[3];
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    TripDriver driver({}, {}, seed);
    for (int trip = 0; trip < 3; ++trip) {
      const TripResult result = driver.drive();
      EXPECT_TRUE(result.located);
      shares[trip].push_back(result.memory_error_m / result.odometry_error_m);
      errors_m[trip].push_back(result.memory_error_m);
    }
  }
  for (int trip = 0; trip < 3; ++trip) {
    EXPECT_LT(median(shares[trip]), 0.2) << "trip " << trip + 1;
    EXPECT_LT(median(errors_m[trip]), 0.2) << "trip " << trip + 1;
  }
}

TEST(LocalisationRoundTrip, ThreeTripsInOneMissionAreNoWorseThanOne) {
  std::vector<double> one_m, three_m;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    one_m.push_back(TripDriver({}, {}, seed).drive(1).memory_error_m);
    three_m.push_back(TripDriver({}, {}, seed).drive(3).memory_error_m);
  }
  EXPECT_LT(median(three_m), 1.5 * median(one_m));
}

/// Normalised estimation error squared of the pose: 3 on average where the covariance is right.
/// Sightings are thinned and given a floor of error, so that it may stay below; above it would mean
/// a robot that is surer than it may be.
TEST(LocalisationRoundTrip, IsNoSurerOfItsPlaceThanItMayBe) {
  double nees = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    nees += TripDriver({}, {}, seed).drive().nees / static_cast<double>(kSeeds);
  }
  EXPECT_GT(nees, 0.5);
  EXPECT_LT(nees, 4.5);
}

TEST(LocalisationRoundTrip, EveryFifthSightingMayBeWrong) {
  TripSettings often_wrong;
  often_wrong.wrong_share = 0.2;
  std::vector<double> shares;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const TripResult result = TripDriver(often_wrong, {}, seed).drive();
    shares.push_back(result.memory_error_m / result.odometry_error_m);
  }
  EXPECT_LT(median(shares), 0.2);
}

TEST(LocalisationRoundTrip, TheSameSeedIsTheSameRunBitForBit) {
  const auto run = [] {
    TripDriver driver({}, {}, 5);
    std::vector<double> all;
    for (int trip = 0; trip < 2; ++trip) {
      const TripResult result = driver.drive();
      all.insert(all.end(), {result.memory_error_m, result.nees});
    }
    for (const memory::Landmark& one : driver.known().landmarks) {
      all.insert(all.end(), {one.position->x_m, one.position->var_x_m2, one.position->cov_xy_m2});
    }
    return all;
  };
  EXPECT_EQ(run(), run());
}

TEST(LocalisationRoundTrip, LearnsTheWayThereAndBack) {
  TripDriver driver({}, {}, 1);
  driver.drive();
  memory::RouteMap routes;
  routes.know(driver.known().routes);
  const memory::RoutePlan there = routes.path_to(1, 15);
  ASSERT_TRUE(there.found);
  const double straight_m = std::abs(driver.truth()[14].x_m - driver.truth()[0].x_m);
  EXPECT_NEAR(there.distance_m, straight_m, 0.1 * straight_m);
  const memory::RoutePlan back = routes.path_to(15, 1);
  ASSERT_TRUE(back.found);
  EXPECT_NEAR(back.distance_m, straight_m, 0.1 * straight_m);
}

}  // namespace
}  // namespace striate::agent
