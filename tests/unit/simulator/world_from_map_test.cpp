#include "striate/platform/simulator/world_from_map.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/passage.hpp"
#include "striate/platform/simulator/static_shapes.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/platform/simulator/world_writer.hpp"

namespace striate::simulator {
namespace {

/// A room of 12 m x 5 m in cells of 5 cm, with a wall that leaves 1 m.
FloorPicture room() {
  FloorPicture picture;
  picture.cell_m = 0.05;
  picture.origin = {2.0, -1.0};
  picture.stands = cv::Mat1b(100, 240, std::uint8_t{0});
  cv::rectangle(picture.stands, {0, 0, 240, 100}, 255, 1);
  picture.stands(cv::Rect(120, 20, 3, 80)).setTo(255);
  picture.free = picture.stands == 0;
  return picture;
}

TEST(WorldFromMap, HasItsWallsWhereTheMapHasThem) {
  const FloorPicture picture = room();
  const MapWorld made = world_from_map(picture, "room");
  const FloorPlan plan = build_floor_plan(made.world);
  const std::vector<StaticShape> walls = standing_shapes(made.world, plan);
  for (int row = 0; row < picture.stands.rows; row += 3) {
    for (int column = 0; column < picture.stands.cols; column += 3) {
      const Point2 place{picture.origin.x_m + (column + 0.5) * picture.cell_m + made.moved.x_m,
                         picture.origin.y_m + (row + 0.5) * picture.cell_m + made.moved.y_m};
      const bool inside = std::ranges::any_of(walls, [&](const StaticShape& wall) {
        return distance_m(disc(place, 0.0), wall.shape) <= 0.0;
      });
      EXPECT_EQ(inside, picture.stands(row, column) != 0) << column << ' ' << row;
    }
  }
  EXPECT_NEAR(widest_passage(made.world, plan).width_m, 0.95, 0.06);
  EXPECT_GT(made.world.goal_beyond_m, 11.0);
  EXPECT_LT(made.world.start.x_m, 3.0);
}

TEST(WorldFromMap, OfOneThatIsTallerThanWideLiesDown) {
  FloorPicture tall = room();
  cv::transpose(tall.stands, tall.stands);
  cv::transpose(tall.free, tall.free);
  tall.origin = {-1.0, 2.0};
  const MapWorld made = world_from_map(tall, "tall", Pose2{0.0, 4.0, kPi / 2.0});
  EXPECT_TRUE(made.turned);
  EXPECT_NEAR(made.world.length_m, 12.6, 1e-9);
  EXPECT_NEAR(made.world.start.x_m, 4.0 + made.moved.x_m, 1e-9);
  EXPECT_NEAR(made.world.start.y_m, made.moved.y_m, 1e-9);
  EXPECT_NEAR(made.world.start.heading_rad, 0.0, 1e-9);
}

TEST(WorldFromMap, KeepsClearOfTheRimOfAMapThatHasNoWallsThere) {
  FloorPicture open;
  open.cell_m = 0.05;
  open.stands = cv::Mat1b(200, 200, std::uint8_t{0});
  open.stands(cv::Rect(90, 90, 20, 20)).setTo(255);
  open.free = open.stands == 0;
  config::Diagnostics diagnostics("open.yaml");
  (void)parse_world(world_as_yaml(world_from_map(open, "open").world), diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
}

TEST(WorldFromMap, LeavesSpecksOutAndHangsLampsAboveTheFloor) {
  FloorPicture picture = room();
  for (int i = 10; i < 90; i += 8) picture.stands(i, 40) = 255;
  picture.free = picture.stands == 0;
  EXPECT_EQ(world_from_map(picture, "dust").world.obstacles.size(),
            world_from_map(room(), "clean").world.obstacles.size());
  EXPECT_GE(world_from_map(picture, "dust").world.lights.size(), 1u);
}

TEST(WorldFromMap, IsRefusedWhereItCannotBeBuilt) {
  FloorPicture picture = room();
  EXPECT_THROW((void)world_from_map(picture, "a", Pose2{8.0, 3.0, 0.0}), UserError) << "a wall";
  EXPECT_THROW((void)world_from_map(picture, "a", Pose2{1e9, 3.0, 0.0}), UserError) << "outside";
  picture.cell_m = 0.6;
  EXPECT_THROW((void)world_from_map(picture, "a"), UserError) << "60 m wide";
  picture.cell_m = 0.005;
  EXPECT_THROW((void)world_from_map(picture, "a"), UserError) << "a doll's house";
  picture.free.setTo(0);
  EXPECT_THROW((void)world_from_map(picture, "a"), UserError);
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 240; ++column) {
      picture.stands(row, column) = (row / 2 + column / 2) % 2 != 0 ? 255 : 0;
    }
  }
  picture.free = picture.stands == 0;
  picture.cell_m = 0.05;
  EXPECT_THROW((void)world_from_map(picture, "a"), UserError) << "a chessboard";
}

}  // namespace
}  // namespace striate::simulator
