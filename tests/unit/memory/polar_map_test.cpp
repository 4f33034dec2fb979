#include "striate/memory/short_term/polar_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace striate::memory {
namespace {

constexpr double kPi = std::numbers::pi;
const TimePoint kSeen = TimePoint(std::chrono::seconds(2));
const TimePoint kLookedAt = TimePoint(std::chrono::seconds(3));

TEST(PolarMap, RingsGrowFromThirtyCentimetresToSixMetres) {
  EXPECT_NEAR(PolarMap::ring_outer_m(0), 0.30, 1e-9);
  EXPECT_NEAR(PolarMap::ring_outer_m(15), 6.0, 1e-9);
  double last_width = 0.0;
  for (int ring = 1; ring < PolarMap::kRings; ++ring) {
    const double width = PolarMap::ring_outer_m(ring) - PolarMap::ring_outer_m(ring - 1);
    EXPECT_GT(width, last_width);
    last_width = width;
    const double middle = 0.5 * (PolarMap::ring_outer_m(ring) + PolarMap::ring_outer_m(ring - 1));
    EXPECT_EQ(PolarMap::ring_of(middle), ring);
  }
  EXPECT_EQ(PolarMap::ring_of(6.1), PolarMap::kRings);
}

TEST(PolarMap, SectorZeroLooksAheadAndSectorsCountToTheLeft) {
  EXPECT_EQ(PolarMap::sector_of(0.0), 0);
  EXPECT_EQ(PolarMap::sector_of(0.04), 0);
  EXPECT_EQ(PolarMap::sector_of(-0.04), 0);
  EXPECT_EQ(PolarMap::sector_of(0.5 * kPi), 18);
  EXPECT_EQ(PolarMap::sector_of(-0.5 * kPi), 54);
  EXPECT_EQ(PolarMap::sector_of(kPi), 36);
  for (int s = 0; s < PolarMap::kSectors; ++s) {
    EXPECT_EQ(PolarMap::sector_of(PolarMap::sector_bearing_rad(s)), s);
  }
}

TEST(PolarMap, OneThingMakesACellOccupiedAndAFewFreePatchesDoNotMakeItFree) {
  LocalGrid grid;
  for (int y = -4; y <= 4; ++y) {
    for (int x = 0; x <= 60; ++x) grid.add({x, y}, -2.0F, kSeen);
  }
  grid.add({40, 0}, 6.0F, kSeen);
  const PolarMap map = read_polar_map(grid, {}, kLookedAt);
  const PolarMap::Cell& thing = map.at(0, PolarMap::ring_of(2.02));
  EXPECT_EQ(thing.state, CellState::occupied);
  EXPECT_NEAR(thing.age_s, 1.0, 1e-3);
  EXPECT_EQ(map.at(0, PolarMap::ring_of(1.2)).state, CellState::free);
  EXPECT_EQ(map.at(0, PolarMap::ring_of(5.0)).state, CellState::unknown);
  EXPECT_TRUE(std::isinf(map.at(0, PolarMap::ring_of(5.0)).age_s));
  EXPECT_EQ(map.at(36, PolarMap::ring_of(2.0)).state, CellState::unknown);
}

TEST(PolarMap, TurnsAgainstTheRobotWithoutBlur) {
  LocalGrid grid;
  for (int d = -1; d <= 1; ++d) grid.add({60 + d, 0}, 3.0F, kSeen);
  for (int turn = 0; turn < PolarMap::kSectors; ++turn) {
    const PolarMap map = read_polar_map(grid, {0.0, 0.0, turn * PolarMap::kSector_rad}, kLookedAt);
    int occupied = 0;
    for (const PolarMap::Cell& cell : map.cells) occupied += cell.state == CellState::occupied;
    const int sector = (PolarMap::kSectors - turn) % PolarMap::kSectors;
    EXPECT_EQ(map.at(sector, PolarMap::ring_of(3.02)).state, CellState::occupied) << turn;
    EXPECT_LE(occupied, 2) << turn;
  }
}

}  // namespace
}  // namespace striate::memory
