#include "memory/blank_view.hpp"

#include <gtest/gtest.h>

#include "tests/reference/looks.hpp"

namespace striate {
namespace {

FloorState ahead(const LocalGrid& grid, double distance_m) {
  return grid.state(LocalGrid::cell_of({distance_m, 0.0}));
}

TEST(BlankView, IsTakenForAWallCloseByAfterSomePictures) {
  LocalGrid grid;
  BlankView view;
  view.see(looks::blank_percept(100), {}, grid);
  EXPECT_EQ(ahead(grid, 0.6), FloorState::unknown);  // one picture may be blurred
  for (int i = 2; i < 7; ++i) view.see(looks::blank_percept(100 * i), {}, grid);
  EXPECT_EQ(ahead(grid, 0.6), FloorState::occupied);
  EXPECT_EQ(ahead(grid, 1.5), FloorState::unknown);
  EXPECT_EQ(ahead(grid, 0.2), FloorState::unknown);
}

TEST(BlankView, DoesNotOverruleFloorThatWasSeenFree) {
  LocalGrid grid;
  BlankView view;
  for (int x = 0; x < 40; ++x) grid.add({x, 0}, -2.0F, looks::at_ms(50));
  for (int i = 1; i < 10; ++i) view.see(looks::blank_percept(100 * i), {}, grid);
  EXPECT_EQ(ahead(grid, 0.6), FloorState::free);
}

TEST(BlankView, NeedsTheWholeViewToBeBlankForSeveralPicturesInARow) {
  LocalGrid grid;
  BlankView view;
  for (int i = 1; i < 12; ++i) {
    Percept percept = looks::blank_percept(100 * i);
    if (i % 3 == 0) looks::see_thing(percept, 0.2, 0.08, 3.0);
    view.see(percept, {}, grid);
  }
  EXPECT_EQ(ahead(grid, 0.6), FloorState::unknown);
}

/// A dark wall close by: noise matches in a fifth of the columns, at any distance.
TEST(BlankView, WhatNoiseMatchesInTheDarkIsNotSeen) {
  LocalGrid grid;
  BlankView view;
  for (int i = 1; i < 8; ++i) {
    Percept percept = looks::blank_percept(100 * i);
    for (std::size_t u = static_cast<std::size_t>(i); u < percept.columns.size(); u += 5) {
      percept.columns[u].obstacle_m = 1.2 + 0.05 * static_cast<double>(u % 40);
      percept.columns[u].obstacle_confidence = 0.5;
    }
    view.see(percept, {}, grid);
  }
  EXPECT_EQ(ahead(grid, 0.6), FloorState::occupied);
}

TEST(BlankView, FarToTheSideIsTheWallThatIsDrivenAlong) {
  LocalGrid grid;
  BlankView view;
  for (int i = 1; i < 10; ++i) view.see(looks::blank_percept(100 * i, 1.2), {}, grid);
  for (double b = 0.8; b < 1.6; b += 0.05) {
    const Point2 at{0.6 * std::cos(b), 0.6 * std::sin(b)};
    EXPECT_EQ(grid.state(LocalGrid::cell_of(at)), FloorState::unknown);
  }
}

}  // namespace
}  // namespace striate
