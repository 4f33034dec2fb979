#include "striate/memory/short_term/occupancy_updater.hpp"

#include <gtest/gtest.h>

#include "tests/reference/looks.hpp"

namespace striate::memory {
namespace {

class Evidence : public testing::Test {
 protected:
  void look(const perception::Percept& percept, const Pose2& pose = {}) {
    writer.write(percept, pose, grid);
  }
  CellState at(double x_m, double y_m) const { return grid.state(LocalGrid::cell_of({x_m, y_m})); }
  OccupancyUpdater writer{OccupancySettings{}, 1.20};
  LocalGrid grid;
};

TEST_F(Evidence, UnknownIsNeverFree) {
  for (int i = 0; i < 20; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_thing(percept, 0.0, 0.1, 3.0);  // seen, but no floor before it
    look(percept);
  }
  for (double x = 0.1; x < 2.6; x += 0.05) EXPECT_NE(at(x, 0.0), CellState::free) << x;
  EXPECT_EQ(at(4.0, 0.0), CellState::unknown);  // hidden behind it
  EXPECT_EQ(at(2.0, 0.6), CellState::unknown);  // columns that know nothing
}

TEST_F(Evidence, FloorIsFreeOnlyWhereItWasSeen) {
  for (int i = 0; i < 4; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_floor(percept, 2.2, 4.0);
    look(percept);
  }
  EXPECT_EQ(at(1.9, 0.0), CellState::unknown);  // below the view
  EXPECT_EQ(at(2.5, 0.0), CellState::free);
  EXPECT_EQ(at(3.8, 0.5), CellState::free);
  EXPECT_EQ(at(4.3, 0.0), CellState::unknown);
  EXPECT_EQ(at(2.5, 1.5), CellState::unknown);  // beside the view
}

TEST_F(Evidence, FarThingsBlockAfterAFewLooksNearOnesAtOnce) {
  perception::Percept far = looks::blank_percept(0);
  looks::see_thing(far, 0.0, 0.1, 2.5);
  look(far);
  EXPECT_NE(at(2.5, 0.0), CellState::occupied);
  look(far);
  look(far);
  EXPECT_EQ(at(2.5, 0.0), CellState::occupied);

  perception::Percept near = looks::blank_percept(0, 1.2);
  looks::see_thing(near, 1.2, 0.1, 0.8);
  look(near);
  EXPECT_EQ(at(0.8 * std::cos(1.2), 0.8 * std::sin(1.2)), CellState::occupied);
}

TEST_F(Evidence, ALoneWrongColumnDoesNotBlock) {
  for (int i = 0; i < 5; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_floor(percept, 1.0, 4.0);
    percept.columns[80].obstacle_m = 2.0;
    percept.columns[80].obstacle_confidence = 0.9;
    percept.columns[80].free_to_m = 1.9;
    look(percept);
  }
  for (double x = 1.5; x < 2.5; x += 0.05) EXPECT_NE(at(x, 0.0), CellState::occupied) << x;
}

TEST_F(Evidence, AWiderBaselinePutsAFarThingMoreExactly) {
  const auto blocked_depth_cells = [](double baseline_m) {
    OccupancyUpdater updater{OccupancySettings{}, 1.20};
    LocalGrid cells;
    for (int i = 0; i < 12; ++i) {
      perception::Percept percept = looks::blank_percept(100 * i);
      percept.disparity.baseline_m = baseline_m;
      looks::see_thing(percept, 0.0, 0.2, 3.5);
      updater.write(percept, {}, cells);
    }
    int blocked = 0;
    for (double x = 2.5; x < 4.5; x += LocalGrid::kCell_m) {
      if (cells.state(LocalGrid::cell_of({x, 0.0})) == CellState::occupied) ++blocked;
    }
    return blocked;
  };
  EXPECT_GT(blocked_depth_cells(0.06), blocked_depth_cells(0.24));
}

TEST_F(Evidence, AThinLegBlocks) {
  for (int i = 0; i < 12; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_floor(percept, 1.0, 4.0);
    looks::see_thing(percept, 0.0, 0.0105, 1.8);  // 4 cm: five columns
    look(percept);
  }
  EXPECT_EQ(at(1.8, 0.001), CellState::occupied);
}

TEST_F(Evidence, TheErrorOfTheRangeSpreadsEvidenceAlongTheRayOnly) {
  for (int i = 0; i < 8; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_thing(percept, 0.0, 0.06, 4.5);
    look(percept);
  }
  // sigma is 0.29 m at 4.5 m.
  EXPECT_EQ(at(4.35, 0.0), CellState::occupied);
  EXPECT_EQ(at(4.65, 0.0), CellState::occupied);
  EXPECT_EQ(at(4.5, 0.45), CellState::unknown);
}

TEST_F(Evidence, WhatIsGoneIsClearedWithinTwoSeconds) {
  for (int i = 0; i < 30; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_floor(percept, 1.0, 4.5);
    looks::see_thing(percept, 0.0, 0.1, 2.5);
    look(percept);
  }
  ASSERT_EQ(at(2.5, 0.0), CellState::occupied);
  for (int i = 30; i < 50; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_floor(percept, 1.0, 4.5);
    look(percept);
  }
  EXPECT_EQ(at(2.5, 0.0), CellState::free);
}

TEST_F(Evidence, WhatIsSeenThroughIsGoneThoughTheFloorThereIsBelowTheView) {
  for (const double height_m : {1.6, 0.3}) {
    for (int i = 0; i < 30; ++i) {
      perception::Percept percept = looks::blank_percept(100 * i);
      looks::see_thing(percept, 0.0, 0.2, 0.8);
      percept.obstacles.push_back({0.0, 0.8, 0.3, height_m, 0.9, 40, 120});
      look(percept);
    }
    ASSERT_EQ(at(0.8, 0.0), CellState::occupied);
    for (int i = 30; i < 50; ++i) {
      perception::Percept percept = looks::blank_percept(100 * i);
      looks::see_floor(percept, 1.4, 4.0);  // at 0.8 m all above 0.51 m is in view
      look(percept);
    }
    // The person has gone; the low box may still be there, and nothing says that floor is free.
    EXPECT_EQ(at(0.8, 0.0), height_m > 1.0 ? CellState::unknown : CellState::occupied);
    grid.forget();
  }
}

TEST_F(Evidence, WhatComesWhereFloorWasSeenCountsAsMoving) {
  perception::Percept empty = looks::blank_percept(0);
  looks::see_floor(empty, 1.0, 4.5);
  for (int i = 0; i < 6; ++i) look(empty);
  perception::Percept person = looks::blank_percept(700);
  looks::see_floor(person, 1.0, 4.5);
  looks::see_thing(person, 0.0, 0.1, 2.5);
  look(person);
  person.stamp = looks::at_ms(800);
  look(person);
  EXPECT_EQ(at(2.5, 0.0), CellState::occupied);  // two looks, not the old free evidence first
  EXPECT_GT(grid.moving(LocalGrid::cell_of({2.5, 0.0})), 0.5F);
}

TEST_F(Evidence, WhatStoodThereFromTheFirstLookIsStill) {
  for (int i = 0; i < 10; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_floor(percept, 1.0, 4.5);
    looks::see_thing(percept, 0.0, 0.1, 2.5);
    look(percept);
  }
  EXPECT_EQ(grid.moving(LocalGrid::cell_of({2.5, 0.0})), 0.0F);
}

TEST_F(Evidence, WhatIsLowWasTakenForFloorFromFartherOffAndHasNotMoved) {
  perception::Percept empty = looks::blank_percept(0);
  looks::see_floor(empty, 1.0, 4.5);
  for (int i = 0; i < 6; ++i) look(empty);
  for (int i = 0; i < 3; ++i) {
    perception::Percept parcel = looks::blank_percept(700 + 100 * i);
    looks::see_floor(parcel, 1.0, 4.5);
    looks::see_thing(parcel, 0.0, 0.1, 2.5);
    parcel.obstacles.push_back({0.0, 2.5, 0.4, 0.12, 0.9, 60, 100});
    look(parcel);
  }
  EXPECT_EQ(at(2.5, 0.0), CellState::occupied);
  EXPECT_EQ(grid.moving(LocalGrid::cell_of({2.5, 0.0})), 0.0F);
}

TEST_F(Evidence, TheFloorBeneathWhatHangsSaysNothingWhereTheViewDoesNotReachUpToIt) {
  for (int i = 0; i < 10; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_thing(percept, 0.0, 0.2, 2.2);
    for (perception::Column& column : percept.columns) {
      if (column.obstacle_m < 3.0) column.hangs_from_m = 1.02;
    }
    look(percept);
  }
  const auto look_at_floor = [&](int first, double top_slope) {
    for (int i = first; i < first + 20; ++i) {
      perception::Percept percept = looks::blank_percept(100 * i);
      percept.top_slope = top_slope;
      looks::see_floor(percept, 1.0, 4.5);
      look(percept);
    }
  };
  ASSERT_EQ(at(2.2, 0.0), CellState::occupied);
  look_at_floor(10, -0.14);  // 0.89 m is the highest in view 2.2 m away
  EXPECT_EQ(at(2.2, 0.0), CellState::occupied);
  look_at_floor(30, 0.06);
  EXPECT_EQ(at(2.2, 0.0), CellState::free);
}

TEST_F(Evidence, TheFloorBeneathWhatHangsSaysLittleNearByWhereItsEndsAreOutOfView) {
  for (int i = 0; i < 10; ++i) {
    perception::Percept percept = looks::blank_percept(100 * i);
    looks::see_thing(percept, 0.0, 0.2, 1.5);
    for (perception::Column& column : percept.columns) {
      if (column.obstacle_m < 3.0) column.hangs_from_m = 1.02;
    }
    look(percept);
  }
  const auto look_at_floor = [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      perception::Percept percept = looks::blank_percept(100 * i);
      looks::see_floor(percept, 1.0, 4.5);
      look(percept);
    }
  };
  look_at_floor(10, 30);
  EXPECT_EQ(at(1.5, 0.0), CellState::occupied);
  look_at_floor(30, 130);
  EXPECT_EQ(at(1.5, 0.0), CellState::free);
}

}  // namespace
}  // namespace striate::memory
