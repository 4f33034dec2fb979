#include "striate/behaviours/control/arbiter.hpp"

#include <gtest/gtest.h>

#include "tests/reference/looks.hpp"

namespace striate::behaviours {
namespace {

using looks::at_ms;

Wish wish(double forward_m_s, int ms) {
  Wish w;
  w.forward_m_s = forward_m_s;
  w.pan_rad = 0.3;
  w.stamp = at_ms(ms);
  return w;
}

TEST(Arbiter, NobodyMeansStand) {
  Arbiter arbiter;
  EXPECT_EQ(arbiter.decide(at_ms(100)).forward_m_s, 0.0);
  EXPECT_EQ(arbiter.owner(), MotorOwner::nobody);
}

TEST(Arbiter, EmergencyGoesBeforeGuardGoesBeforeBehaviour) {
  Arbiter arbiter;
  arbiter.offer(MotorOwner::behaviour, wish(0.4, 100));
  EXPECT_EQ(arbiter.decide(at_ms(100)).forward_m_s, 0.4);
  arbiter.offer(MotorOwner::guard, wish(0.2, 100));
  EXPECT_EQ(arbiter.decide(at_ms(100)).forward_m_s, 0.2);
  arbiter.offer(MotorOwner::emergency, wish(0.0, 100));
  EXPECT_EQ(arbiter.decide(at_ms(100)).forward_m_s, 0.0);
  EXPECT_EQ(arbiter.owner(), MotorOwner::emergency);
  arbiter.release(MotorOwner::emergency);
  arbiter.release(MotorOwner::guard);
  EXPECT_EQ(arbiter.decide(at_ms(100)).forward_m_s, 0.4);
}

TEST(Arbiter, AWishLapsesAfterTwoHundredMilliseconds) {
  Arbiter arbiter;
  arbiter.offer(MotorOwner::behaviour, wish(0.4, 100));
  EXPECT_EQ(arbiter.decide(at_ms(300)).forward_m_s, 0.4);
  const Wish stand = arbiter.decide(at_ms(301));
  EXPECT_EQ(stand.forward_m_s, 0.0);
  EXPECT_EQ(stand.pan_rad, 0.3);  // the head stays where it looks
  EXPECT_EQ(arbiter.owner(), MotorOwner::nobody);
}

TEST(Arbiter, AmongTheClaimsOfOneCycleTheFirstThatIsFreshDrivesAndNobodyElseHoldsTheMotors) {
  Arbiter arbiter;
  arbiter.offer(MotorOwner::guard, wish(0.0, 500));
  const Claim behaviour{MotorOwner::behaviour, wish(0.4, 500)};
  const Claim pilot{MotorOwner::pilot, wish(0.2, 500)};
  const Claim old_pilot{MotorOwner::pilot, wish(0.2, 299)};
  EXPECT_EQ(arbiter.decide({behaviour, pilot}, at_ms(500)).owner, MotorOwner::pilot);
  const Claim won = arbiter.decide({behaviour, old_pilot}, at_ms(500));
  EXPECT_EQ(won.owner, MotorOwner::behaviour);
  EXPECT_EQ(won.wish.forward_m_s, 0.4);
  EXPECT_EQ(arbiter.decide({}, at_ms(500)).owner, MotorOwner::nobody);
}

TEST(Arbiter, AnOwnerThatFallsSilentGivesWayToTheNext) {
  Arbiter arbiter;
  arbiter.offer(MotorOwner::guard, wish(0.0, 100));
  arbiter.offer(MotorOwner::behaviour, wish(0.4, 350));
  EXPECT_EQ(arbiter.decide(at_ms(350)).forward_m_s, 0.4);
  EXPECT_EQ(arbiter.owner(), MotorOwner::behaviour);
}

}  // namespace
}  // namespace striate::behaviours
