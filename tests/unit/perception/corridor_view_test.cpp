#include "striate/perception/corridor/corridor_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "striate/perception/corridor/edge_points.hpp"
#include "striate/perception/corridor/ray_of.hpp"
#include "striate/perception/corridor/upright_plane.hpp"
#include "striate/perception/corridor/vanishing_point.hpp"
#include "striate/perception/corridor/wall_profile.hpp"
#include "striate/perception/obstacles/wall_completion.hpp"
#include "tests/unit/perception/obstacles_synthetic_room.hpp"

namespace striate::perception {
namespace {

using synthetic::look;
using synthetic::Room;

/// Paints what the left eye sees of a corridor whose walls, floor and ceiling are each one grey,
/// with a darker skirting: blank walls, edges only where surfaces meet.
cv::Mat1b paint(const Room& room, const HeadPose& head, double noise_grey = 0.0) {
  const DisparityMap map = look(room, head);
  const ViewGeometry geometry(map, head, {});
  cv::Mat1b grey(120, 160, uchar{90});
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      if (!std::isfinite(map.disparity_px(v, u))) continue;
      const SpacePoint p = geometry.point(u, v, map.disparity_px(v, u));
      double value = 150.0;  // walls and boxes
      if (p.z_m < 0.005)
        value = 100.0;  // floor
      else if (p.z_m < 0.10)
        value = 60.0;  // skirting
      else if (p.z_m > 2.69)
        value = 180.0;
      value += noise_grey * synthetic::noise(static_cast<std::uint64_t>(v) * 512 + u);
      grey(v, u) = cv::saturate_cast<uchar>(value);
    }
  }
  return grey;
}

CorridorView view(const Room& room, const HeadPose& head, const DisparityMap& map,
                  double noise_grey = 0.0) {
  return view_corridor(paint(room, head, noise_grey), map, head, {}, {});
}

TEST(Corridor, FindsHeadingAndWallsAtAnyHeadingOfTheRobot) {
  for (const double heading : {-0.3, -0.1, 0.0, 0.15, 0.3}) {
    const Room room{{}, true, 0.9, 1.5, heading};
    const CorridorView seen = view(room, {}, look(room, {}, 0.2), 3.0);
    ASSERT_TRUE(seen.valid) << heading;
    EXPECT_NEAR(seen.heading_rad, heading, radians(1.0)) << heading;
    EXPECT_GT(seen.confidence, 0.5) << heading;
    EXPECT_TRUE(std::isfinite(seen.left_m) || std::isfinite(seen.right_m)) << heading;
    EXPECT_TRUE(!std::isfinite(seen.left_m) || std::abs(seen.left_m - 0.9) < 0.1) << seen.left_m;
    EXPECT_TRUE(!std::isfinite(seen.right_m) || std::abs(seen.right_m - 1.5) < 0.15)
        << seen.right_m;
  }
}

TEST(Corridor, HeadingIncludesPanAndTiltOfTheHead) {
  const Room room{{}, true, 1.2, 1.2, 0.1};
  for (const HeadPose head : {HeadPose{0.3, 0.0}, HeadPose{-0.25, -0.2}, HeadPose{0.0, -0.3}}) {
    const CorridorView seen = view(room, head, look(room, head, 0.2), 3.0);
    ASSERT_TRUE(seen.valid);
    EXPECT_NEAR(seen.heading_rad, 0.1, radians(1.2));
  }
}

TEST(Corridor, BlankWallsWithoutAnyDisparityStillGiveTheHeading) {
  const Room room{{}, true, 1.0, 1.4, -0.12};
  const CorridorView seen = view(room, {}, synthetic::empty_map(), 3.0);
  ASSERT_TRUE(seen.valid);
  EXPECT_NEAR(seen.heading_rad, -0.12, radians(1.0));
  EXPECT_EQ(seen.left_m, kNothing_m);
  EXPECT_EQ(seen.right_m, kNothing_m);
}

TEST(Corridor, AWallInTheDarkIsFoundByDepthAlone) {
  const Room room{{}, true, 1.0, 1.4, 0.2};
  const cv::Mat1b black(120, 160, uchar{8});
  const CorridorView seen = view_corridor(black, look(room, {}, 0.2), {}, {}, {});
  ASSERT_TRUE(seen.valid);
  EXPECT_NEAR(seen.heading_rad, 0.2, radians(2.0));
}

TEST(Corridor, ABoxAndAPersonDoNotMoveTheWalls) {
  const Room room{
      {{2.0, 2.5, 0.3, 0.8, 0.0, 1.0}, {3.0, 3.3, -0.9, -0.5, 0.0, 1.8}}, true, 1.2, 1.2, 0.0};
  const CorridorView seen = view(room, {}, look(room, {}, 0.2), 3.0);
  ASSERT_TRUE(seen.valid);
  EXPECT_NEAR(seen.heading_rad, 0.0, radians(1.5));
  EXPECT_NEAR(seen.left_m, 1.2, 0.12);
  EXPECT_NEAR(seen.right_m, 1.2, 0.12);
}

TEST(Corridor, NothingToSeeIsNotValid) {
  EXPECT_FALSE(view_corridor({}, synthetic::empty_map(), {}, {}, {}).valid);
  const cv::Mat1b blank(120, 160, uchar{120});
  EXPECT_FALSE(view_corridor(blank, synthetic::empty_map(), {}, {}, {}).valid);
  cv::Mat1b noisy(120, 160);
  for (int i = 0; i < 120 * 160; ++i) {
    noisy(i / 160, i % 160) = cv::saturate_cast<uchar>(120.0 + 20.0 * synthetic::noise(i));
  }
  EXPECT_LT(view_corridor(noisy, synthetic::empty_map(), {}, {}, {}).confidence, 0.5);
}

TEST(UprightPlanes, AWallVanishesWhereTheCorridorDoes) {
  const Room room{{}, true, 0.8, 3.0, -0.2};
  const DisparityMap map = look(room, {}, 0.2);
  const std::vector<UprightPlane> planes = find_upright_planes(map, ViewGeometry(map, {}, {}), 240);
  ASSERT_FALSE(planes.empty());
  EXPECT_NEAR(planes[0].vanishing_u_px, 79.5 + 203.0 * std::tan(0.2), 5.0);
}

TEST(UprightPlanes, AWallSquareToTheCameraVanishesNowhere) {
  const Room room{{{3.0, 3.2, -5.0, 5.0, 0.0, 2.7}}, true, 5.0, 5.0};
  const DisparityMap map = look(room, {}, 0.05);
  EXPECT_TRUE(find_upright_planes(map, ViewGeometry(map, {}, {}), 240).empty());
}

TEST(WallCompletion, PutsABlankWallWhereTheCorridorHasIt) {
  CorridorView corridor{true, 0.0, 1.2, 1.2, 0.9};
  const DisparityMap map = synthetic::empty_map();
  std::vector<Column> columns(160);
  for (int u = 0; u < 160; ++u) columns[u].bearing_rad = std::atan((79.5 - u) / 203.0);
  complete_with_walls(columns, corridor, map, ViewGeometry(map, {}, {}));
  EXPECT_NEAR(columns[0].obstacle_m, 1.2 / std::sin(columns[0].bearing_rad), 1e-6);
  EXPECT_GT(columns[0].obstacle_confidence, 0.2);
  EXPECT_LT(columns[0].obstacle_confidence, 0.5);
  EXPECT_EQ(columns[80].obstacle_m, kNothing_m);
}

TEST(WallCompletion, LeavesOpenWhatStereoSeesThrough) {
  CorridorView corridor{true, 0.0, 1.2, 1.2, 0.9};
  const DisparityMap map = look({{}, true, 4.5, 4.5}, {}, 0.1);  // a hall, not a corridor
  std::vector<Column> columns(160);
  for (int u = 0; u < 160; ++u) columns[u].bearing_rad = std::atan((79.5 - u) / 203.0);
  complete_with_walls(columns, corridor, map, ViewGeometry(map, {}, {}));
  EXPECT_EQ(columns[5].obstacle_m, kNothing_m);
}

int ray_by_arc_tangent(float du, float dv) {
  const double turn = std::atan2(dv, du) / (2.0 * std::numbers::pi) + 0.5;
  return std::min(kRays - 1, static_cast<int>(turn * kRays));
}

TEST(VanishingPoint, RaysAreThoseOfTheArcTangent) {
  for (const float reach_px : {0.03F, 1.0F, 7.3F, 160.0F, 4000.0F}) {
    for (int i = -200'000; i <= 200'000; ++i) {
      const double angle = i * std::numbers::pi / 180'000;  // the borders of the rays among them
      const float du = reach_px * static_cast<float>(std::cos(angle));
      const float dv = reach_px * static_cast<float>(std::sin(angle));
      ASSERT_EQ(ray_of(du, dv), ray_by_arc_tangent(du, dv)) << du << " " << dv;
    }
  }
  for (const float du : {-2.0F, -0.0F, 0.0F, 2.0F}) {
    for (const float dv : {-2.0F, -0.0F, 0.0F, 2.0F}) {
      EXPECT_EQ(ray_of(du, dv), ray_by_arc_tangent(du, dv)) << du << " " << dv;
    }
  }
}

}  // namespace
}  // namespace striate::perception
