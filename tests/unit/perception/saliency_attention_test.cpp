#include <gtest/gtest.h>

#include <cmath>

#include "striate/perception/saliency/attention.hpp"

namespace striate::perception {
namespace {

SalientRegion region(double bearing_rad, double salience, double v_px = 60.0) {
  SalientRegion r;
  r.bearing_rad = bearing_rad;
  r.salience = salience;
  r.v_px = v_px;
  r.width_px = r.height_px = 10.0;
  return r;
}

/// The bearing handed out next; NaN for none.
double next_bearing(Attention& attention) {
  const SalientRegion* next = attention.next();
  return next != nullptr ? next->bearing_rad : std::nan("");
}

TEST(Attention, HandsOutTheMostSalientFirstAndEachOnce) {
  Attention attention({});
  attention.look({region(0.0, 0.6), region(0.3, 1.0), region(-0.3, 0.8), region(0.2, 0.1)}, {});
  EXPECT_EQ(next_bearing(attention), 0.3);
  EXPECT_EQ(next_bearing(attention), -0.3);
  EXPECT_EQ(next_bearing(attention), 0.0);
  EXPECT_EQ(attention.next(), nullptr) << "0.1 is below the least";
}

TEST(Attention, ComesBackOnlyAfterAWhileAndToTheMostSalientFirst) {
  Attention attention({});
  const std::vector<SalientRegion> seen = {region(0.0, 0.7), region(0.3, 1.0)};
  attention.look(seen, {});
  while (attention.next() != nullptr) {
  }
  attention.look(seen, {0.1, 0.0, 0.0});
  EXPECT_EQ(attention.next(), nullptr);
  attention.look(seen, {1.0, 0.0, 0.0});
  EXPECT_NEAR(attention.inhibition(seen[0]), std::exp(-1.1 / 2.0), 1e-9);
  EXPECT_EQ(next_bearing(attention), 0.3);
  EXPECT_EQ(next_bearing(attention), 0.0);
}

TEST(Attention, AVisitedPlaceMovesWithTheTurnAndTheTilt) {
  Attention attention({});
  attention.look({region(0.0, 1.0)}, {});
  EXPECT_EQ(next_bearing(attention), 0.0);
  // The robot turned 0.4 rad to the left and tilted its head up: the thing is to the right, lower.
  attention.look({region(-0.4, 1.0, 80.0), region(0.0, 0.5)}, {0.1, -0.4, 20.0});
  EXPECT_EQ(next_bearing(attention), 0.0) << "what is at the old bearing now is new";
  EXPECT_EQ(attention.next(), nullptr);
}

TEST(Attention, OneAboveTheOtherAreTwoPlaces) {
  Attention attention({});
  attention.look({region(0.0, 1.0, 30.0), region(0.0, 0.9, 90.0)}, {});
  EXPECT_NE(attention.next(), nullptr);
  EXPECT_NE(attention.next(), nullptr);
  EXPECT_EQ(attention.next(), nullptr);
}

TEST(Attention, WrapsBehindTheRobotAndForgetsTheOldestOfTooMany) {
  Attention attention({});
  attention.look({region(3.1, 1.0)}, {});
  EXPECT_NE(attention.next(), nullptr);
  EXPECT_EQ(attention.inhibition(region(-3.13, 1.0)), 1.0);
  for (int k = 0; k < 40; ++k) {
    attention.look({region(0.0, 1.0, 20.0 * k)}, {0.001, 0.0, 0.0});
    EXPECT_NE(attention.next(), nullptr);
  }
  EXPECT_EQ(attention.inhibition(region(3.1, 1.0)), 0.0);
}

TEST(Attention, NothingIsHandedOutOfNothing) {
  Attention attention({});
  EXPECT_EQ(attention.next(), nullptr);
  attention.look({}, {});
  EXPECT_EQ(attention.next(), nullptr);
}

}  // namespace
}  // namespace striate::perception
