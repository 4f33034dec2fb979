#include "striate/memory/short_term/local_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace striate::memory {
namespace {

const TimePoint kNow = TimePoint(std::chrono::seconds(5));

TEST(LocalGrid, HoldsNothingKnownAtFirst) {
  LocalGrid grid;
  EXPECT_EQ(grid.state({0, 0}), CellState::unknown);
  EXPECT_EQ(grid.last_seen({0, 0}), TimePoint{});
}

TEST(LocalGrid, APointStaysWhereItIsWhileTheRobotDrives) {
  LocalGrid grid;
  const GridCell thing = LocalGrid::cell_of({3.02, -1.01});
  grid.add(thing, 3.0F, kNow);
  for (int step = 0; step <= 100; ++step) grid.centre_on({0.05 * step, 0.02 * step});
  EXPECT_EQ(grid.state(thing), CellState::occupied);
  EXPECT_EQ(grid.last_seen(thing), kNow);
  EXPECT_EQ(grid.state({thing.x + 1, thing.y}), CellState::unknown);
}

TEST(LocalGrid, WhatComesIntoTheWindowIsUnknownNotWhatLeftIt) {
  LocalGrid grid;
  for (int y = -100; y <= 100; ++y) grid.add({-100, y}, -3.0F, kNow);
  grid.centre_on({6.0, 0.0});
  EXPECT_FALSE(grid.holds({-100, 0}));
  for (int x = grid.first().x; x < grid.first().x + LocalGrid::kSide; ++x) {
    EXPECT_EQ(grid.state({x, 0}), CellState::unknown) << x;
  }
}

TEST(LocalGrid, AJumpForgetsAll) {
  LocalGrid grid;
  grid.add({0, 0}, 3.0F, kNow);
  grid.centre_on({100.0, 0.0});
  grid.centre_on({0.0, 0.0});
  EXPECT_EQ(grid.state({0, 0}), CellState::unknown);
}

TEST(LocalGrid, WorksAtNegativeCoordinates) {
  LocalGrid grid;
  grid.centre_on({-30.0, -30.0});
  const GridCell cell = LocalGrid::cell_of({-30.01, -29.99});
  EXPECT_EQ(cell, (GridCell{-601, -600}));
  grid.add(cell, 2.0F, kNow);
  EXPECT_EQ(grid.state(cell), CellState::occupied);
  EXPECT_EQ(grid.state({cell.x + 1, cell.y}), CellState::unknown);
}

TEST(LocalGrid, MovingThingsFadeFasterThanStillOnes) {
  LocalGrid grid;
  grid.add({1, 1}, 3.0F, kNow);
  grid.add({2, 2}, 3.0F, kNow);
  grid.set_moving({2, 2}, 1.0F);
  for (int i = 0; i < 6; ++i) grid.fade({0.99F, 0.99F, 0.8F});
  EXPECT_EQ(grid.state({1, 1}), CellState::occupied);
  EXPECT_EQ(grid.state({2, 2}), CellState::unknown);
}

TEST(LocalGrid, ASpeckStandsOnlyWithStrongEvidence) {
  LocalGrid grid;
  grid.add({5, 5}, 2.0F, kNow);
  EXPECT_EQ(grid.state({5, 5}), CellState::occupied);
  EXPECT_FALSE(grid.stands({5, 5}));
  grid.add({5, 5}, 1.2F, kNow);
  EXPECT_TRUE(grid.stands({5, 5}));
  for (int x = 20; x < 23; ++x) grid.add({x, 5}, 2.0F, kNow);
  EXPECT_TRUE(grid.stands({21, 5}));
  EXPECT_FALSE(grid.stands({20, 5}));  // an end has one neighbour only
}

TEST(LocalGrid, EvidenceIsBounded) {
  LocalGrid grid;
  for (int i = 0; i < 1000; ++i) grid.add({0, 0}, 1.0F, kNow);
  EXPECT_FLOAT_EQ(grid.log_odds({0, 0}), LocalGrid::kMost);
  for (int i = 0; i < 1000; ++i) grid.add({0, 0}, -1.0F, kNow);
  EXPECT_FLOAT_EQ(grid.log_odds({0, 0}), LocalGrid::kLeast);
}

TEST(LocalGrid, BlurSoftensOldEvidenceAndSparesNew) {
  LocalGrid grid;
  grid.add({10, 10}, 3.0F, TimePoint(std::chrono::seconds(1)));
  grid.add({-10, -10}, 3.0F, TimePoint(std::chrono::seconds(9)));
  grid.blur_older_than(TimePoint(std::chrono::seconds(5)), 0.2F);
  EXPECT_LT(grid.log_odds({10, 10}), 2.5F);
  EXPECT_GT(grid.log_odds({11, 10}), 0.1F);
  EXPECT_FLOAT_EQ(grid.log_odds({-10, -10}), 3.0F);
}

TEST(LocalGrid, PlacesThatCannotBeAreInNoPatchOfIt) {
  LocalGrid grid;
  const double none = std::nan("");
  for (const double odd : {-1e300, -1e12, 1e12, 1e300, none}) {
    grid.centre_on({odd, -odd});
    grid.add(LocalGrid::cell_of({odd, odd}), 1.0F, {});
    EXPECT_EQ(grid.state(LocalGrid::cell_of({-odd, 0.0})), CellState::unknown);
    grid.centre_on({0.0, 0.0});
    EXPECT_FALSE(grid.holds(LocalGrid::cell_of({odd, 0.0}))) << odd;
  }
}

}  // namespace
}  // namespace striate::memory
