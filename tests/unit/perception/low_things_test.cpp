#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "striate/perception/low_things/floor_band.hpp"
#include "striate/perception/perception.hpp"
#include "tests/unit/perception/low_things_pictures.hpp"

/// Things about a pixel high at the working size: seen on the near floor at twice that size.
namespace striate::perception {
namespace {

using synthetic::Room;

constexpr HeadPose kRestingDown{0.0, -0.227};
constexpr HeadPose kGlancingDown{0.0, -0.42};

Room floor_with(double front_m, double height_m) {
  return {{{front_m, front_m + 0.3, -0.2, 0.2, 0.0, height_m}}, true, 1.4, 1.4};
}

/// Of the columns that the thing fills, the share that sees it within 0.15 m.
double share_that_sees(const Room& room, const HeadPose& head,
                       const LowThingSettings& settings = {}) {
  PerceptionSettings all;
  all.low_things = settings;
  Perception eyes(all, {});
  const Percept percept = eyes.see(synthetic::photograph(room, head));
  int seen = 0, columns = 0;
  for (const Column& column : percept.columns) {
    const double front_m = room.boxes[0].x0_m;
    if (std::abs(std::tan(column.bearing_rad) * front_m) > 0.16) continue;
    ++columns;
    const bool here = std::abs(column.obstacle_m * std::cos(column.bearing_rad) - front_m) < 0.15;
    seen += here && column.free_to_m < front_m + 0.05;
  }
  return static_cast<double>(seen) / columns;
}

TEST(LowThings, OfEightCentimetresAreSeenInAGlance) {
  for (const double height_m : {0.08, 0.10, 0.12, 0.15}) {
    EXPECT_GT(share_that_sees(floor_with(1.8, height_m), kGlancingDown), 0.7) << height_m;
  }
}

TEST(LowThings, AreNotLookedForWhereTheViewBeginsFarAway) {
  LowThingSettings off;
  off.on = false;
  const Room room = floor_with(2.2, 0.08);
  EXPECT_EQ(share_that_sees(room, kRestingDown), share_that_sees(room, kRestingDown, off));
}

TEST(LowThings, AreSeenFromSixCentimetresOnWhenTheHeadGlancesDown) {
  EXPECT_GT(share_that_sees(floor_with(1.6, 0.06), kGlancingDown), 0.7);
}

TEST(LowThings, AreNotSeenAtTheWorkingSizeAlone) {
  LowThingSettings off;
  off.on = false;
  EXPECT_LT(share_that_sees(floor_with(2.0, 0.08), kGlancingDown, off), 0.3);
}

TEST(LowThings, AnEmptyFloorHasNone) {
  for (const HeadPose head :
       {kRestingDown, kGlancingDown, HeadPose{0.3, -0.3}, HeadPose{0.0, -0.58}}) {
    Room room{{}, true, 3.0, 3.0};
    Perception eyes({}, {});
    const Percept percept = eyes.see(synthetic::photograph(room, head, {.noisy = 4.0}));
    for (const Column& column : percept.columns) EXPECT_GT(column.obstacle_m, 2.7) << head.tilt_rad;
  }
}

TEST(LowThings, AnErrorOfTheTiltMakesNone) {
  Room room{{}, true, 3.0, 3.0};
  StereoFrame frame = synthetic::photograph(room, kGlancingDown);
  frame.head.tilt_rad += 0.012;
  Perception eyes({}, {});
  for (const Column& column : eyes.see(frame).columns) EXPECT_GT(column.obstacle_m, 2.5);
}

TEST(LowThings, ThePaperSettingLooksForNone) {
  PerceptionSettings paper;
  paper.stereo.mode = StereoMode::paper;
  PerceptionSettings without = paper;
  without.low_things.on = false;
  const StereoFrame frame = synthetic::photograph(floor_with(2.0, 0.12), kGlancingDown);
  const Percept a = Perception(paper, {}).see(frame);
  const Percept b = Perception(without, {}).see(frame);
  for (std::size_t u = 0; u < a.columns.size(); ++u) {
    EXPECT_EQ(a.columns[u].obstacle_m, b.columns[u].obstacle_m);
  }
}

TEST(FloorBandRows, AreMovedByPartsOfAPixel) {
  std::vector<std::uint16_t> row(200);
  const auto wave = [](double x) { return 2000.0 + 1500.0 * std::sin(0.9 * x); };
  for (int x = 0; x < 200; ++x) row[x] = static_cast<std::uint16_t>(std::lround(wave(x)));
  for (const int sixteenths : {0, 16, -16, 5, 40, -27, 168}) {
    std::vector<std::uint16_t> moved(200);
    move_row(row.data(), 200, sixteenths, moved.data());
    for (int x = 20; x < 180; ++x) EXPECT_NEAR(moved[x], wave(x - sixteenths / 16.0), 40.0) << x;
  }
}

TEST(FloorBandRows, MoveNothingOutOfTheImage) {
  std::vector<std::uint16_t> row(32), moved(32, 7);
  std::iota(row.begin(), row.end(), std::uint16_t{100});
  move_row(row.data(), 32, 16 * 500, moved.data());
  EXPECT_EQ(moved, std::vector<std::uint16_t>(32, 100));
  move_row(row.data(), 32, -16 * 500, moved.data());
  EXPECT_EQ(moved, std::vector<std::uint16_t>(32, 131));
}

}  // namespace
}  // namespace striate::perception
