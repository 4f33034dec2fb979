#include "striate/memory/short_term/landmark_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/reference/looks.hpp"

namespace striate::memory {
namespace {

using looks::at_ms;

LandmarkSighting look(std::string_view name, int ms, double distance_m = 2.0,
                      std::int64_t landmark = 7) {
  return {landmark, name, at_ms(ms), 0.8, 0.5, distance_m};
}

TEST(LandmarkMemory, IsConfirmedByLooksThatFollowEachOther) {
  LandmarkMemory memory({.confirming_looks = 3, .confirming_s = 1.0});
  for (const int ms : {0, 500, 2000, 2500}) memory.see(look("book", ms), {}, {});
  EXPECT_FALSE(memory.find("book")->confirmed);
  memory.see(look("book", 3000), {}, {});
  EXPECT_TRUE(memory.find("book")->confirmed);
  EXPECT_TRUE(memory.in_sight("book", at_ms(3400), std::chrono::milliseconds(500)));
  EXPECT_FALSE(memory.in_sight("book", at_ms(3600), std::chrono::milliseconds(500)));
}

TEST(LandmarkMemory, PutsALandmarkWhereItWasWhenTheImageWasTaken) {
  LandmarkMemory memory({});
  const Pose2 at{1.0, 0.0, 0.0};
  memory.see({7, "book", at_ms(0), 0.8, 0.0, 2.0}, at, Pose2{2.0, 0.0, 0.1});
  const LandmarkInMind* book = memory.find("book");
  EXPECT_NEAR(book->place.x_m, 3.0, 1e-12);
  EXPECT_NEAR(book->place.y_m, 0.0, 1e-12);
  EXPECT_NEAR(book->bearing_rad, -0.1, 1e-12);
}

TEST(LandmarkMemory, BearingsFollowTheRobotWithAndWithoutAPlace) {
  LandmarkMemory memory({});
  memory.see({1, "near", at_ms(0), 0.8, 0.0, 2.0}, {}, {});
  memory.see({2, "far", at_ms(0), 0.8, 0.0, std::numeric_limits<double>::infinity()}, {}, {});
  memory.move({}, {2.0, -2.0, 0.3});
  EXPECT_NEAR(memory.find("near")->bearing_rad, std::acos(0.0) - 0.3, 1e-12);
  EXPECT_NEAR(memory.find("far")->bearing_rad, -0.3, 1e-12);
}

TEST(LandmarkMemory, AFarLookDoesNotReplaceANearOne) {
  LandmarkMemory memory({});
  memory.see(look("book", 0, 1.0), {}, {});
  const Point2 place = memory.find("book")->place;
  memory.see(look("book", 100, 5.0), {}, {});
  EXPECT_EQ(memory.find("book")->place.x_m, place.x_m);
}

TEST(LandmarkMemory, TheOneNotSeenForLongestMakesRoom) {
  LandmarkMemory memory({});
  const int all = static_cast<int>(LandmarkMemory::kCapacity);
  for (int i = 0; i < all; ++i) memory.see(look("n" + std::to_string(i), i, 2.0, i + 1), {}, {});
  memory.see(look("n0", 1000, 2.0, 1), {}, {});
  memory.see(look("new", 1001, 2.0, 1000), {}, {});
  EXPECT_EQ(memory.find("n1"), nullptr);
  EXPECT_NE(memory.find("n0"), nullptr);
  EXPECT_NE(memory.find("new"), nullptr);
}

TEST(LandmarkMemory, CutsALongNameAndFindsItByTheWholeOne) {
  LandmarkMemory memory({});
  const std::string name(100, 'x');
  memory.recall(3, name, {1.0, 0.0}, 0.1);
  ASSERT_NE(memory.find(name), nullptr);
  EXPECT_EQ(memory.find(name)->sightings, 0);
  EXPECT_FALSE(memory.find(name)->confirmed);
}

}  // namespace
}  // namespace striate::memory
