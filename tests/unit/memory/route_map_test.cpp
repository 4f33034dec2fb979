#include "striate/memory/localisation/route_map.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace striate::memory {
namespace {

std::vector<std::int64_t> stations_of(const RoutePlan& way) {
  std::vector<std::int64_t> stations;
  for (const RouteStep& step : way.all()) stations.push_back(step.landmark);
  return stations;
}

TEST(RouteMap, TheWayLeadsOverWhatWasDriven) {
  RouteMap routes;
  routes.driven(1, 2, 5.0, 0.1);
  routes.driven(2, 3, 7.0, std::numbers::pi / 2.0);
  const RoutePlan way = routes.path_to(1, 3);
  ASSERT_TRUE(way.found);
  EXPECT_EQ(stations_of(way), (std::vector<std::int64_t>{2, 3}));
  EXPECT_DOUBLE_EQ(way.distance_m, 12.0);
  EXPECT_DOUBLE_EQ(way.steps[1].turn_rad, std::numbers::pi / 2.0);
  EXPECT_FALSE(routes.path_to(1, 9).found);
  EXPECT_TRUE(routes.path_to(1, 1).found);
}

TEST(RouteMap, BackIsTheSameWayWithTheTurnsTheOtherWayRound) {
  RouteMap routes;
  routes.driven(1, 2, 5.0, 0.0);
  routes.driven(2, 3, 7.0, 1.0);
  const RoutePlan way = routes.path_to(3, 1);
  ASSERT_TRUE(way.found);
  EXPECT_EQ(stations_of(way), (std::vector<std::int64_t>{2, 1}));
  EXPECT_DOUBLE_EQ(way.steps[0].turn_rad, -1.0);
  EXPECT_TRUE(way.steps[0].backwards);
}

TEST(RouteMap, FailuresMakeAWayLonger) {
  RouteMap routes;
  routes.driven(1, 2, 10.0, 0.0);
  routes.driven(1, 3, 8.0, 0.0);
  routes.driven(3, 2, 8.0, 0.0);
  EXPECT_EQ(routes.path_to(1, 2).size, 1U);
  routes.failed(1, 2);
  routes.failed(1, 2);
  EXPECT_EQ(stations_of(routes.path_to(1, 2)), (std::vector<std::int64_t>{3, 2}));
}

TEST(RouteMap, DrivenAgainItIsSurerAndCountedOnce) {
  RouteMap routes;
  routes.driven(1, 2, 10.0, 3.1);
  const double before_m2 = routes.find(1, 2)->distance_var_m2;
  routes.driven(1, 2, 10.4, -3.1);
  const Route& route = *routes.find(1, 2);
  EXPECT_EQ(routes.all().size(), 1U);
  EXPECT_EQ(route.successes, 2);
  EXPECT_NEAR(route.distance_m, 10.2, 1e-3);
  EXPECT_GT(std::abs(route.turn_rad), 3.1) << "averaged across the seam of the circle";
  EXPECT_LT(route.distance_var_m2, before_m2);
}

TEST(RouteMap, TellsOnceWhatHasChanged) {
  RouteMap routes;
  routes.know(std::vector<Route>{{1, 2, 5.0, 0.0, 0.1, 0.1, 3, 0}});
  routes.driven(2, 3, 7.0, 0.0);
  std::vector<std::int64_t> told;
  const auto note = [&](const Route& route) { told.push_back(route.to); };
  routes.take_changed(note);
  routes.take_changed(note);
  EXPECT_EQ(told, (std::vector<std::int64_t>{3}));
}

TEST(RouteMap, WhatDoesNotFitIsLeftOut) {
  RouteMap routes;
  for (std::int64_t k = 1; k < 2000; ++k) routes.driven(k, k + 1, 1.0, 0.0);
  EXPECT_EQ(routes.all().size(), RouteMap::kStations - 1);
  EXPECT_FALSE(routes.path_to(1, 1500).found);
  EXPECT_FALSE(routes.path_to(1, 200).found) << "more than a RoutePlan holds";
  EXPECT_TRUE(routes.path_to(1, 60).found);
}

}  // namespace
}  // namespace striate::memory
