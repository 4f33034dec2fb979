#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "striate/memory/long_term/activation.hpp"
#include "striate/memory/long_term/learning.hpp"

namespace striate::memory {
namespace {

using testing::HasSubstr;

TEST(Activation, OneUseFadesWithTheRootOfItsAge) {
  const UseHistory history{1, 0.0, {0.0}};
  EXPECT_DOUBLE_EQ(base_level(history, 100.0, 0.5), std::log(0.1));
  EXPECT_DOUBLE_EQ(base_level(history, 10000.0, 0.5), std::log(0.01));
}

TEST(Activation, TenUsesAreExact) {
  UseHistory history;
  double sum = 0.0;
  for (int k = 0; k < 10; ++k) {
    note_use(history, 7.0 * k);
    sum += std::pow(100.0 - 7.0 * k, -0.3);
  }
  EXPECT_NEAR(base_level(history, 100.0, 0.3), std::log(sum), 1e-12);
}

TEST(Activation, OlderUsesAreSpreadEvenlySinceTheFirst) {
  // 14 uses; the last ten were 1 .. 10 s ago, the first 101 s ago.
  UseHistory history{14, 0.0, {}};
  double sum = 0.0;
  for (int k = 1; k <= 10; ++k) {
    history.recent_s.push_back(101.0 - k);
    sum += 1.0 / std::sqrt(k);
  }
  sum += 4.0 * (std::sqrt(101.0) - std::sqrt(10.0)) / (0.5 * (101.0 - 10.0));
  EXPECT_NEAR(base_level(history, 101.0, 0.5), std::log(sum), 1e-12);
}

TEST(Activation, TheHybridFormIsNearTheSumOverAllUses) {
  UseHistory history;
  double exact = 0.0;
  for (int k = 0; k < 200; ++k) {
    note_use(history, 50.0 * k);
    exact += std::pow(10010.0 - 50.0 * k, -0.5);
  }
  EXPECT_NEAR(base_level(history, 10010.0, 0.5), std::log(exact), 0.02);
}

TEST(Activation, NeverUsedIsMinusInfinityAndUsesNowAreFinite) {
  EXPECT_EQ(base_level({}, 5.0, 0.5), -std::numeric_limits<double>::infinity());
  const UseHistory together{30, 5.0, std::vector<double>(10, 5.0)};
  EXPECT_DOUBLE_EQ(base_level(together, 5.0, 0.5), std::log(30.0));
}

TEST(Activation, ANightInTheCupboardForgetsNothing) {
  // Operating time stands still while the robot is off: the same now, the same activation.
  const UseHistory history{1, 0.0, {0.0}};
  EXPECT_EQ(base_level(history, 60.0, 0.5), base_level(history, 60.0, 0.5));
  EXPECT_LT(base_level(history, 61.0, 0.5), base_level(history, 60.0, 0.5));
}

TEST(Strength, ConsolidatesAndEnfeeblesAsSpecified) {
  const LongTermSettings settings;
  EXPECT_DOUBLE_EQ(consolidated(0.5, settings), 0.625);
  EXPECT_DOUBLE_EQ(enfeebled(0.5, settings), 0.45);
  double up = 0.5;
  double down = 0.5;
  for (int k = 0; k < 10000; ++k) {
    up = consolidated(up, settings);
    down = enfeebled(down, settings);
  }
  EXPECT_LT(up, 1.0);
  EXPECT_GT(down, 0.0);
}

TEST(Activation, TheTotalIsTheSumOfItsParts) {
  const LongTermSettings settings;
  Landmark landmark;
  landmark.id = 7;
  landmark.name = "book";
  landmark.strength = 0.8;
  landmark.history = {1, 0.0, {0.0}};
  const Situation situation{100.0, 7, {3}};
  const std::vector<Route> routes = {{3, 7, 2.0, 0.0, 0.1, 0.1, 3, 1}};
  const Activation parts = activation_of(landmark, situation, routes, settings);
  EXPECT_DOUBLE_EQ(parts.goal, 2.0);
  EXPECT_DOUBLE_EQ(parts.route, 4.0 / 6.0);
  EXPECT_DOUBLE_EQ(parts.strength, std::log(0.8 / (1.0 - 0.8)));
  EXPECT_DOUBLE_EQ(parts.total(), std::log(0.1) + 2.0 + 4.0 / 6.0 + std::log(0.8 / (1.0 - 0.8)));
  const Activation elsewhere = activation_of(landmark, {100.0, 8, {4}}, routes, settings);
  EXPECT_DOUBLE_EQ(elsewhere.goal + elsewhere.route, 0.0);
}

TEST(Activation, IsExplainedInWordsAndNumbers) {
  Landmark landmark;
  landmark.id = 7;
  landmark.name = "book";
  landmark.strength = 0.8;
  landmark.history = {3, 0.0, {90.0, 50.0, 0.0}};
  const std::vector<std::string> lines = explain(landmark, {100.0, 7, {}}, {}, {});
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_THAT(lines[0], HasSubstr("'book' has activation +"));
  EXPECT_THAT(lines[1], HasSubstr("used 3 times, last 10 s of work ago"));
  EXPECT_THAT(lines[2], HasSubstr("strength is 0.80: it was mostly there"));
  EXPECT_THAT(lines[3], HasSubstr("+2.00  the task is after it"));
}

TEST(Learning, AnotherPlaceIsAnotherUseAndTheSamePlaceIsNot) {
  Learning learning({});
  EXPECT_TRUE(learning.seen(1, {0.0, 0.0}));
  EXPECT_FALSE(learning.seen(1, {0.1, 0.1}));
  EXPECT_TRUE(learning.seen(2, {0.1, 0.1}));
  EXPECT_TRUE(learning.seen(1, {0.6, 0.0}));
}

TEST(Learning, ThreeFramesInARowAreOneMissedOpportunity) {
  Learning learning({});
  const Point2 here{0.0, 0.0};
  EXPECT_FALSE(learning.missed(1, here));
  EXPECT_FALSE(learning.missed(1, here));
  EXPECT_TRUE(learning.missed(1, here));
  const Point2 there{1.0, 0.0};
  EXPECT_FALSE(learning.missed(1, there));
  EXPECT_FALSE(learning.missed(1, there));
  learning.found(1);
  EXPECT_FALSE(learning.missed(1, there)) << "the row was broken";
}

TEST(Learning, MissedAgainFromTheSamePlaceIsTheSameMiss) {
  Learning learning({.missed_frames = 1});
  EXPECT_TRUE(learning.missed(1, {0.0, 0.0}));
  EXPECT_FALSE(learning.missed(1, {0.1, 0.0}));
  EXPECT_TRUE(learning.missed(1, {0.6, 0.0}));
  EXPECT_FALSE(learning.missed(1, {0.7, 0.0}));
  (void)learning.seen(1, {0.7, 0.0});
  EXPECT_TRUE(learning.missed(1, {0.7, 0.0})) << "it was there in between";
}

}  // namespace
}  // namespace striate::memory
