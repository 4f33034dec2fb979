#include "striate/memory/short_term/salient_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reference/looks.hpp"

namespace striate::memory {
namespace {

using looks::at_ms;

perception::SalientRegion region(double bearing_rad, double salience,
                                 double distance_m = perception::kNothing_m) {
  perception::SalientRegion seen;
  seen.bearing_rad = bearing_rad;
  seen.salience = salience;
  seen.distance_m = distance_m;
  seen.width_px = 20.0;
  return seen;
}

int used(const SalientMemory& memory) {
  return static_cast<int>(std::count_if(memory.regions().begin(), memory.regions().end(),
                                        [](const RememberedRegion& r) { return r.used; }));
}

const RememberedRegion* near(const SalientMemory& memory, double bearing_rad) {
  for (const RememberedRegion& r : memory.regions()) {
    if (r.used && std::abs(r.bearing_rad - bearing_rad) < 0.02) return &r;
  }
  return nullptr;
}

TEST(SalientMemory, ASecondLookIsAHitNotANewRegion) {
  SalientMemory memory({});
  memory.see({region(0.20, 0.5, 2.0)}, 1.0 / 203, at_ms(100));
  memory.see({region(0.22, 0.6, 2.2)}, 1.0 / 203, at_ms(200));
  ASSERT_EQ(used(memory), 1);
  const RememberedRegion* r = near(memory, 0.22);
  ASSERT_NE(r, nullptr);
  EXPECT_EQ(r->hits, 2);
  EXPECT_NEAR(r->activation, 1.1, 1e-9);
  EXPECT_NEAR(r->size_rad, 20.0 / 203, 1e-9);
}

TEST(SalientMemory, TheSameBearingAtAnotherDistanceIsAnotherThing) {
  SalientMemory memory({});
  memory.see({region(0.2, 0.5, 1.0), region(0.2, 0.5, 3.0)}, 0.005, at_ms(100));
  EXPECT_EQ(used(memory), 2);
}

TEST(SalientMemory, HoldsSevenAndEvictsTheLeastActive) {
  SalientMemory memory({});
  for (int i = 0; i < 7; ++i) {
    memory.see({region(-0.9 + 0.3 * i, 0.3 + 0.1 * i)}, 0.005, at_ms(100));
  }
  ASSERT_EQ(used(memory), 7);
  memory.see({region(1.5, 0.2)}, 0.005, at_ms(200));  // weaker than all: not taken in
  EXPECT_EQ(near(memory, 1.5), nullptr);
  memory.see({region(1.5, 0.8)}, 0.005, at_ms(300));
  EXPECT_EQ(used(memory), 7);
  EXPECT_NE(near(memory, 1.5), nullptr);
  EXPECT_EQ(near(memory, -0.9), nullptr);  // the least active is gone
}

TEST(SalientMemory, AnUnmatchedRegionExpires) {
  SalientMemory memory({});
  memory.see({region(0.5, 0.5)}, 0.005, at_ms(0));
  memory.attend(0.0, at_ms(7900), std::chrono::milliseconds(100));
  EXPECT_EQ(used(memory), 1);
  memory.attend(0.0, at_ms(8200), std::chrono::milliseconds(100));
  EXPECT_EQ(used(memory), 0);
}

TEST(SalientMemory, AttentionMovesOnFromWhatWasLookedAt) {
  SalientMemory memory({});
  memory.see({region(0.5, 0.9), region(-0.5, 0.4)}, 0.005, at_ms(0));
  ASSERT_NEAR(memory.most_interesting(at_ms(0))->bearing_rad, 0.5, 1e-9);
  for (int ms = 100; ms <= 700; ms += 100) {
    memory.attend(0.5, at_ms(ms), std::chrono::milliseconds(100));
  }
  ASSERT_NE(memory.most_interesting(at_ms(700)), nullptr);
  EXPECT_NEAR(memory.most_interesting(at_ms(700))->bearing_rad, -0.5, 1e-9);
  EXPECT_NEAR(memory.most_interesting(at_ms(7500))->bearing_rad, 0.5, 1e-9);  // inhibition ends
}

TEST(SalientMemory, RegionsKeepTheirPlaceWhileTheRobotMoves) {
  SalientMemory memory({});
  memory.see({region(0.0, 0.5, 3.0), region(0.6, 0.5)}, 0.005, at_ms(0));
  memory.move({}, {0.0, 0.0, 0.5});
  EXPECT_NE(near(memory, -0.5), nullptr);
  EXPECT_NE(near(memory, 0.1), nullptr);
  memory.move({0.0, 0.0, 0.5}, {1.0, 0.0, 0.5});
  EXPECT_NEAR(near(memory, -0.5)->distance_m, 2.0, 1e-9);
}

}  // namespace
}  // namespace striate::memory
