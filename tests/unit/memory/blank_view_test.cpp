#include "striate/memory/short_term/blank_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/looks.hpp"

namespace striate::memory {
namespace {

CellState ahead(const LocalGrid& grid, double distance_m) {
  return grid.state(LocalGrid::cell_of({distance_m, 0.0}));
}

TEST(BlankView, IsTakenForAWallCloseByAfterSomeImages) {
  LocalGrid grid;
  BlankView view;
  view.see(looks::blank_percept(100), {}, grid);
  EXPECT_EQ(ahead(grid, 0.6), CellState::unknown);  // one image may be blurred
  for (int i = 2; i < 7; ++i) view.see(looks::blank_percept(100 * i), {}, grid);
  EXPECT_EQ(ahead(grid, 0.6), CellState::occupied);
  EXPECT_EQ(ahead(grid, 1.5), CellState::unknown);
  EXPECT_EQ(ahead(grid, 0.2), CellState::unknown);
}

TEST(BlankView, DoesNotOverruleFloorThatWasSeenFree) {
  LocalGrid grid;
  BlankView view;
  for (int x = 0; x < 40; ++x) grid.add({x, 0}, -2.0F, looks::at_ms(50));
  for (int i = 1; i < 10; ++i) view.see(looks::blank_percept(100 * i), {}, grid);
  EXPECT_EQ(ahead(grid, 0.6), CellState::free);
}

TEST(BlankView, NeedsTheWholeViewToBeBlankForSeveralImagesInARow) {
  LocalGrid grid;
  BlankView view;
  for (int i = 1; i < 12; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    if (i % 3 == 0) looks::see_thing(percept, 0.2, 0.08, 3.0);
    view.see(percept, {}, grid);
  }
  EXPECT_EQ(ahead(grid, 0.6), CellState::unknown);
}

/// A dark wall close by: noise matches in a fifth of the columns, at any distance.
LocalGrid after_noise_alone(double pan_rad, double noise_level) {
  LocalGrid grid;
  BlankView view;
  for (int i = 1; i < 10; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i, pan_rad);
    percept.noise_level = noise_level;
    for (std::size_t u = static_cast<std::size_t>(i); u < percept.columns.size(); u += 5) {
      percept.columns[u].obstacle_m = 1.2 + 0.05 * static_cast<double>(u % 40);
      percept.columns[u].obstacle_confidence = 0.5;
    }
    view.see(percept, {}, grid);
  }
  return grid;
}

TEST(BlankView, WhatNoiseMatchesInTheDarkIsNotSeen) {
  EXPECT_EQ(ahead(after_noise_alone(0.0, 1.6), 0.6), CellState::occupied);
}

TEST(BlankView, WhereThereIsLittleNoiseMatchesAreThings) {
  EXPECT_EQ(ahead(after_noise_alone(0.0, 0.6), 0.6), CellState::unknown);
}

// The head sweeps past dark walls on both sides when it looks for a gap: they must not shut it.
TEST(BlankView, NoiseAloneCountsOnlyAhead) {
  const LocalGrid grid = after_noise_alone(0.5, 1.6);
  const GridCell seen = LocalGrid::cell_of({0.6 * std::cos(0.5), 0.6 * std::sin(0.5)});
  EXPECT_EQ(grid.state(seen), CellState::unknown);
}

TEST(BlankView, FarToTheSideIsTheWallThatIsDrivenAlong) {
  LocalGrid grid;
  BlankView view;
  for (int i = 1; i < 10; ++i) view.see(looks::blank_percept(100 * i, 1.2), {}, grid);
  for (double b = 0.8; b < 1.6; b += 0.05) {
    const Point2 at{0.6 * std::cos(b), 0.6 * std::sin(b)};
    EXPECT_EQ(grid.state(LocalGrid::cell_of(at)), CellState::unknown);
  }
}

}  // namespace
}  // namespace striate::memory
