#include "striate/memory/short_term/corridor_memory.hpp"

#include <gtest/gtest.h>

namespace striate::memory {
namespace {

perception::CorridorView view(double heading_rad, double left_m, double right_m) {
  return {true, heading_rad, left_m, right_m, 0.8};
}

TEST(CorridorMemory, TheHeadingAtTheStartIsTheFirstEstimate) {
  CorridorMemory corridor;
  corridor.start({1.0, 2.0, 0.7});
  EXPECT_NEAR(corridor.axis_rad(), 0.7, 1e-9);
  EXPECT_NEAR(corridor.offset_m(), 0.0, 1e-9);
  EXPECT_NEAR(corridor.progress_m(), 0.0, 1e-9);
}

TEST(CorridorMemory, ConvergesOnWhatImagesShow) {
  CorridorMemory corridor;
  corridor.start({0.0, 0.0, 0.08});  // the robot stood askew
  for (int i = 0; i < 100; ++i) corridor.see(view(-0.08, 1.0, 1.4), {0, 0, 0.08}, {0, 0, 0.08});
  EXPECT_NEAR(corridor.axis_rad(), 0.0, 0.01);
  EXPECT_NEAR(corridor.offset_m(), 0.2, 0.02);
  EXPECT_NEAR(corridor.width_m(), 2.4, 0.02);
  EXPECT_LT(corridor.axis_std_rad(), 0.05);
}

TEST(CorridorMemory, OneOddImageChangesNothing) {
  CorridorMemory corridor;
  corridor.start({});
  for (int i = 0; i < 60; ++i) corridor.see(view(0.0, 1.2, 1.2), {}, {});
  corridor.see(view(0.6, 0.2, 2.2), {}, {});
  EXPECT_NEAR(corridor.axis_rad(), 0.0, 1e-3);
  EXPECT_NEAR(corridor.offset_m(), 0.0, 1e-3);
}

TEST(CorridorMemory, FollowsTheDriftOfTheOdometry) {
  CorridorMemory corridor;
  corridor.start({});
  Pose2 odometry;
  double drift = 0.0;  // the odometry turns slowly though the robot drives straight
  for (int i = 0; i < 1200; ++i) {
    const Pose2 before = odometry;
    drift += 0.0001;
    odometry = transform(odometry, Pose2{0.05, 0.0, 0.0001});
    corridor.move(before, odometry);
    if (i % 5 == 0) corridor.see(view(0.0, 1.2, 1.2), odometry, odometry);
  }
  EXPECT_NEAR(corridor.axis_rad(), drift, 0.025);  // 7 degrees of drift in 60 m
  EXPECT_NEAR(corridor.progress_m(), 60.0, 0.3);
}

TEST(CorridorMemory, FallsBackToOdometryAndGrowsUnsure) {
  CorridorMemory corridor;
  corridor.start({});
  for (int i = 0; i < 60; ++i) corridor.see(view(0.0, 1.2, 1.2), {}, {});
  const double sure = corridor.offset_std_m();
  corridor.move({}, {5.0, 0.4, 0.0});
  EXPECT_NEAR(corridor.offset_m(), 0.4, 1e-3);
  EXPECT_NEAR(corridor.progress_m(), 5.0, 1e-2);
  EXPECT_GT(corridor.offset_std_m(), sure);
  EXPECT_EQ(corridor.left_m(), perception::kNothing_m);  // not seen for metres
}

TEST(CorridorMemory, OneWallTellsTheOffsetOnceTheWidthIsKnown) {
  CorridorMemory corridor;
  corridor.start({});
  for (int i = 0; i < 60; ++i) corridor.see(view(0.0, 1.2, 1.2), {}, {});
  corridor.move({}, {1.0, 0.0, 0.0});
  for (int i = 0; i < 100; ++i) {
    corridor.see(view(0.0, 1.0, perception::kNothing_m), {1.0, 0, 0}, {1.0, 0, 0});
  }
  EXPECT_NEAR(corridor.offset_m(), 0.2, 0.08);
}

TEST(WallFitter, FindsTwoWallsInTheMap) {
  LocalGrid grid;
  const double heading = 0.06;
  const Pose2 axis{0.0, 0.0, heading};
  for (double x = -1.0; x < 4.0; x += 0.04) {
    grid.add(LocalGrid::cell_of(transform(axis, Point2{x, 1.0})), 3.0F, {});
    grid.add(LocalGrid::cell_of(transform(axis, Point2{x, -1.4})), 3.0F, {});
  }
  WallFitter fitter;
  const WallFit fit = fitter.fit(grid, {}, 0.0);
  ASSERT_TRUE(fit.valid);
  EXPECT_NEAR(fit.heading_rad, heading, 0.015);
  ASSERT_TRUE(fit.left && fit.right);
  EXPECT_NEAR(fit.left_m, 1.0, 0.05);
  EXPECT_NEAR(fit.right_m, 1.4, 0.05);
}

TEST(WallFitter, ABoxIsNoWall) {
  LocalGrid grid;
  for (int x = 20; x < 30; ++x) {
    for (int y = 10; y < 20; ++y) grid.add({x, y}, 3.0F, {});
  }
  WallFitter fitter;
  EXPECT_FALSE(fitter.fit(grid, {}, 0.0).valid);
}

TEST(WallFitter, TheEdgesOfSeenFloorStandForWallsTooPlainToSee) {
  LocalGrid grid;
  for (double x = 0.0; x < 4.0; x += 0.04) {
    for (double y = -1.3; y < 1.1; y += 0.04) {
      grid.add(LocalGrid::cell_of({x, y}), -1.0F, {});
    }
  }
  WallFitter fitter;
  EXPECT_FALSE(fitter.fit(grid, {}, 0.0).valid);
  const WallFit fit = fitter.fit_edges(grid, {}, 0.0, 2.4);
  ASSERT_TRUE(fit.valid);
  EXPECT_NEAR(fit.heading_rad, 0.0, 0.02);
  EXPECT_NEAR(fit.left_m, 1.1, 0.08);
  EXPECT_FALSE(fitter.fit_edges(grid, {}, 0.0, 3.6).valid);  // not as far apart as it should be
}

}  // namespace
}  // namespace striate::memory
