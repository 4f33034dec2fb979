#include <gtest/gtest.h>

#include <algorithm>

#include "striate/perception/obstacles/floor_state.hpp"
#include "striate/perception/obstacles/obstacles.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"
#include "tests/unit/perception/obstacles_synthetic_room.hpp"

namespace striate::perception {
namespace {

using synthetic::Box;
using synthetic::look;
using synthetic::Room;

constexpr Box kCarton{2.0, 2.5, -0.3, 0.3, 0.0, 0.6};

const Column& column_at(const ObstacleView& view, double bearing_rad) {
  return *std::min_element(
      view.columns.begin(), view.columns.end(), [&](const Column& a, const Column& b) {
        return std::abs(a.bearing_rad - bearing_rad) < std::abs(b.bearing_rad - bearing_rad);
      });
}

ObstacleView see(const Room& room, const HeadPose& head = {}, double noise_px = 0.0) {
  return find_obstacles(look(room, head, noise_px), head, {}, {});
}

TEST(ViewGeometry, PutsPixelsWhereTheRayCasterSawThem) {
  const HeadPose head{0.3, -0.35};
  const Room room{{kCarton}};
  const DisparityMap map = look(room, head);
  const ViewGeometry geometry(map, head, {});
  int on_front = 0;
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const SpacePoint p = geometry.point(u, v, map.disparity_px(v, u));
      EXPECT_NEAR(p.z_m, geometry.height_m(v, map.disparity_px(v, u)), 1e-4);
      on_front +=
          std::abs(p.x_m - 2.0) < 1e-3 && p.z_m > 0.01 && p.z_m < 0.6 && std::abs(p.y_m) < 0.301;
    }
  }
  EXPECT_GT(on_front, 1000);
}

TEST(Obstacles, MeasuresABoxAheadToAFewCentimetres) {
  const ObstacleView view = see({{kCarton}}, {0.0, -0.2});
  ASSERT_FALSE(view.obstacles.empty());
  EXPECT_NEAR(view.obstacles[0].distance_m, 2.0, 0.05);
  EXPECT_NEAR(view.obstacles[0].bearing_rad, 0.0, 0.02);
  EXPECT_NEAR(view.obstacles[0].width_m, 0.6, 0.06);
  EXPECT_NEAR(view.obstacles[0].height_m, 0.6, 0.1);
  EXPECT_NEAR(column_at(view, 0.0).obstacle_m, 2.0, 0.05);
  EXPECT_GT(column_at(view, 0.0).obstacle_confidence, 0.7);
}

TEST(Obstacles, BearingIncludesThePanOfTheHead) {
  const ObstacleView view = see({{{1.9, 2.1, 0.9, 1.1, 0.0, 1.0}}, true, 5.0, 5.0}, {0.4, -0.2});
  ASSERT_FALSE(view.obstacles.empty());
  EXPECT_NEAR(view.obstacles[0].bearing_rad, std::atan2(0.95, 1.9), 0.05);
}

TEST(Obstacles, SeesTheEmptyFloorFreeAndNothingOnIt) {
  const ObstacleView view = see({{}, true, 5.0, 5.0}, {0.0, -0.35}, 0.2);
  EXPECT_TRUE(view.obstacles.empty());
  const Column& ahead = column_at(view, 0.0);
  EXPECT_EQ(ahead.obstacle_m, kNothing_m);
  EXPECT_LT(ahead.free_from_m, 2.0);
  EXPECT_GT(ahead.free_to_m, 5.0);
}

TEST(Obstacles, FreeFloorEndsBeforeTheBox) {
  const ObstacleView view = see({{kCarton}}, {0.0, -0.4}, 0.15);
  const Column& ahead = column_at(view, 0.0);
  EXPECT_GT(ahead.free_to_m, ahead.free_from_m);
  EXPECT_LT(ahead.free_to_m, 2.0);
}

TEST(Obstacles, TheFloorBehindABoxIsHiddenAsFarAsItsTopHidesIt) {
  const HeadPose head{0.0, -0.4};
  const ObstacleView view = see({{kCarton}, true, 5.0, 5.0}, head);
  const Column& ahead = column_at(view, 0.0);
  EXPECT_DOUBLE_EQ(ahead.hidden_from_m, ahead.obstacle_m);
  // From 1.2 m up, over the far edge (0.6 m high, 2.5 m away), the floor is seen again at 5 m; the
  // top face is seen, so the last row of the obstacle's own distance is that of its front edge.
  EXPECT_GT(ahead.hidden_to_m, 2.5);
  EXPECT_LT(ahead.hidden_to_m, 5.3);
  EXPECT_EQ(floor_state(ahead, 1.9), FloorState::free);
  EXPECT_EQ(floor_state(ahead, 2.05), FloorState::occupied);
  EXPECT_EQ(floor_state(ahead, 2.4), FloorState::hidden);
  EXPECT_EQ(floor_state(ahead, 7.9), FloorState::unknown);
  const Column& beside = column_at(view, 0.3);
  EXPECT_EQ(floor_state(beside, 2.4), FloorState::free);
  EXPECT_EQ(beside.hidden_from_m, kNothing_m);
}

TEST(Obstacles, BehindWhatIsHigherThanTheCameraAllIsHidden) {
  const Box tall{2.0, 2.5, -0.3, 0.3, 0.0, 1.9};
  for (const auto find : {find_obstacles, find_obstacles_as_in_paper}) {
    const ObstacleView view = find(look({{tall}, true, 5.0, 5.0}, {}), {}, {}, {});
    const Column& ahead = column_at(view, 0.0);
    EXPECT_EQ(ahead.hidden_to_m, kNothing_m);
    EXPECT_EQ(floor_state(ahead, 50.0), FloorState::hidden);
  }
}

TEST(Obstacles, SeesALowBoxWhenTheHeadLooksDown) {
  const ObstacleView view = see({{{1.8, 2.1, -0.2, 0.2, 0.0, 0.15}}}, {0.0, -0.45}, 0.15);
  EXPECT_NEAR(column_at(view, 0.0).obstacle_m, 1.8, 0.15);
}

TEST(Obstacles, ATableTopStandsInTheWayAndALampDoesNot) {
  const ObstacleView table = see({{{2.0, 2.6, -0.5, 0.5, 0.70, 0.75}}});
  EXPECT_NEAR(column_at(table, 0.0).obstacle_m, 2.0, 0.3);
  const ObstacleView lamp = see({{{2.0, 2.6, -0.5, 0.5, 1.6, 1.7}}, true, 5.0, 5.0});
  EXPECT_EQ(column_at(lamp, 0.0).obstacle_m, kNothing_m);
}

TEST(Obstacles, AFewWrongDisparitiesAreNoObstacle) {
  const Room room{{}, true, 5.0, 5.0};
  const HeadPose head{0.0, -0.35};
  DisparityMap map = look(room, head, 0.2);
  for (int i = 0; i < 400; ++i) {  // 2 % of the pixels, anywhere, at any nearer distance
    const int u = static_cast<int>((synthetic::noise(3 * i) + 1.0) * 79.9);
    const int v = static_cast<int>((synthetic::noise(3 * i + 1) + 1.0) * 59.9);
    map.disparity_px(v, u) = static_cast<float>(15.0 + 12.0 * synthetic::noise(3 * i + 2));
  }
  EXPECT_TRUE(find_obstacles(map, head, {}, {}).obstacles.empty());
}

TEST(Obstacles, TheMirrorImageInAShinyFloorCountsAsFloor) {
  const Room room{{}, true, 5.0, 5.0};
  const HeadPose head{0.0, -0.35};
  DisparityMap map = look(room, head, 0.1);
  map.disparity_px(cv::Rect(70, 40, 20, 30)).setTo(2.0F);  // a lamp far behind the floor
  const ObstacleView view = find_obstacles(map, head, {}, {});
  EXPECT_EQ(view.columns[80].obstacle_m, kNothing_m);
  EXPECT_GT(view.columns[80].free_to_m, 4.0);
}

TEST(Obstacles, UnknownIsNeverFree) {
  const HeadPose head{0.0, -0.35};
  DisparityMap map = look({{}, true, 5.0, 5.0}, head);
  synthetic::make_unknown(map, {60, 0, 40, 120});
  const ObstacleView view = find_obstacles(map, head, {}, {});
  EXPECT_LE(view.columns[80].free_to_m, view.columns[80].free_from_m);
  EXPECT_EQ(view.columns[80].obstacle_m, kNothing_m);
  DisparityMap nothing = synthetic::empty_map();
  for (const Column& c : find_obstacles(nothing, head, {}, {}).columns) {
    EXPECT_LE(c.free_to_m, c.free_from_m);
    EXPECT_EQ(c.obstacle_m, kNothing_m);
  }
}

TEST(Obstacles, BridgesABlankPatchOfAWallWithLowerConfidence) {
  const Room room{{}, true, 0.8, 5.0};
  DisparityMap map = look(room, {0.3, 0.0}, 0.1);
  const ObstacleView whole = find_obstacles(map, {0.3, 0.0}, {}, {});
  synthetic::make_unknown(map, {40, 0, 8, 120});
  const ObstacleView view = find_obstacles(map, {0.3, 0.0}, {}, {});
  ASSERT_NE(view.columns[44].obstacle_m, kNothing_m);
  EXPECT_NEAR(view.columns[44].obstacle_m, whole.columns[44].obstacle_m, 0.1);
  EXPECT_LT(view.columns[44].obstacle_confidence, whole.columns[44].obstacle_confidence);
}

TEST(Obstacles, DoesNotBridgeFromABoxToTheWallBehind) {
  Room room{{{1.5, 1.9, 0.0, 0.5, 0.0, 1.3}, {6.0, 6.2, -3.0, 3.0, 0.0, 2.7}}, true, 5.0, 5.0};
  DisparityMap map = look(room, {});
  synthetic::make_unknown(map, {88, 0, 8, 120});
  const ObstacleView view = find_obstacles(map, {}, {}, {});
  EXPECT_EQ(view.columns[92].obstacle_m, kNothing_m);
}

TEST(Obstacles, CalibratesASmallErrorOfTheTilt) {
  const HeadPose truth{0.0, -0.35};
  const HeadPose believed{0.0, -0.34};
  const DisparityMap map = look({{}, true, 5.0, 5.0}, truth, 0.1);
  const ObstacleView view = find_obstacles(map, believed, {}, {});
  EXPECT_NEAR(view.floor_offset_px, 0.2, 0.06);
  EXPECT_TRUE(view.obstacles.empty());
}

TEST(Obstacles, NearestComesFirst) {
  const ObstacleView view = see({{{3.0, 3.3, 0.4, 0.8, 0.0, 1.0}, kCarton}}, {0.0, -0.1}, 0.1);
  ASSERT_GE(view.obstacles.size(), 2U);
  for (std::size_t i = 1; i < view.obstacles.size(); ++i) {
    EXPECT_LE(view.obstacles[i - 1].distance_m, view.obstacles[i].distance_m);
  }
}

TEST(PaperObstacles, ThresholdsTheDisparityIntoBlobs) {
  const Room room{{{2.0, 2.5, -0.3, 0.3, 0.0, 1.3}}, true, 5.0, 5.0};
  const ObstacleView view = find_obstacles_as_in_paper(look(room, {}), {}, {}, {});
  ASSERT_EQ(view.obstacles.size(), 1U);
  EXPECT_NEAR(view.obstacles[0].distance_m, 2.0, 0.1);
  EXPECT_NEAR(view.obstacles[0].width_m, 0.6, 0.1);
  EXPECT_NEAR(column_at(view, 0.0).obstacle_m, 2.0, 0.1);
  EXPECT_EQ(view.columns[0].obstacle_m, kNothing_m);
  EXPECT_NEAR(view.columns[79].free_to_m, view.columns[79].obstacle_m, 1e-9);
}

TEST(PaperObstacles, TheNearThingBelowCountsAndNotTheLargerOneAboveAndBehindIt) {
  const Room room{
      {{2.0, 2.5, -0.3, 0.3, 0.0, 0.9}, {2.7, 3.0, -0.3, 0.3, 0.0, 2.4}}, true, 5.0, 5.0};
  const ObstacleView view = find_obstacles_as_in_paper(look(room, {}), {}, {}, {});
  EXPECT_NEAR(column_at(view, 0.0).obstacle_m, 2.0, 0.15);
}

TEST(PaperObstacles, AnEmptyMapHasNone) {
  EXPECT_TRUE(find_obstacles_as_in_paper({}, {}, {}, {}).columns.empty());
  EXPECT_TRUE(find_obstacles({}, {}, {}, {}).columns.empty());
}

}  // namespace
}  // namespace striate::perception
