#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/perception/motion/motion.hpp"
#include "striate/perception/obstacles/obstacles.hpp"
#include "tests/reference/test_images.hpp"
#include "tests/unit/perception/obstacles_synthetic_room.hpp"

namespace striate::perception {
namespace {

using synthetic::Box;
using synthetic::Room;

MotionSettings on() {
  MotionSettings settings;
  settings.on = true;
  return settings;
}

/// A box in the world, 0.4 m wide, with its near face at x_m.
Box box(double x_m, double y_m) {
  return {x_m, x_m + 0.4, y_m - 0.2, y_m + 0.2, 0.0, 1.1};
}

/// What a robot at `base` sees of boxes that stand, unturned, in the world; `base` does not turn
/// but by the head's pan, so that the room stays axis-parallel. Greys are those of the surface
/// where each pixel lies in the world, less the place of the first box, so that its paint moves
/// with it.
struct Look {
  DisparityMap map;
  cv::Mat1b grey;
  HeadPose head;
  Pose2 base;
};

Look look_at(std::vector<Box> boxes, const Pose2& base, const HeadPose& head) {
  const Box first = boxes.front();
  for (Box& b : boxes)
    b.x0_m -= base.x_m, b.x1_m -= base.x_m, b.y0_m -= base.y_m, b.y1_m -= base.y_m;
  Look look{synthetic::look(Room{boxes, true, 4.0, 4.0}, head, 0.2), {}, head, base};
  look.grey.create(look.map.disparity_px.size());
  const ViewGeometry geometry(look.map, head, {});
  for (int v = 0; v < look.grey.rows; ++v) {
    for (int u = 0; u < look.grey.cols; ++u) {
      const float d = look.map.disparity_px(v, u);
      const SpacePoint p = std::isfinite(d) ? geometry.point(u, v, d) : SpacePoint{};
      look.grey(v, u) = static_cast<uchar>(reference::texture_at(
          static_cast<int>(std::lround((p.y_m + base.y_m - first.y0_m) * 60.0)),
          static_cast<int>(std::lround(p.z_m * 60.0)), 1));
    }
  }
  return look;
}

struct Found {
  std::vector<Column> columns;
  std::vector<MovingThing> moving;
};

Found find(MotionFinder& finder, const Look& look, double at_s) {
  Found found;
  found.columns = find_obstacles(look.map, look.head, {}, {}).columns;
  finder.find({TimePoint{} + from_seconds(at_s), look.head, look.base, look.grey, &look.map},
              found.columns, found.moving);
  return found;
}

TEST(Motion, ABoxThatMovedAsideIsFoundWithItsVelocity) {
  MotionFinder finder(on(), {});
  EXPECT_TRUE(find(finder, look_at({box(3.0, -0.3), box(4.0, 1.0)}, {}, {}), 0.0).moving.empty());
  const Found found = find(finder, look_at({box(3.0, 0.2), box(4.0, 1.0)}, {}, {}), 0.4);
  ASSERT_EQ(found.moving.size(), 1U);
  const MovingThing& thing = found.moving[0];
  EXPECT_NEAR(thing.distance_m, 3.0, 0.1);
  EXPECT_NEAR(thing.bearing_rad, std::atan2(0.2, 3.0), 0.03);
  EXPECT_NEAR(thing.width_m, 0.4, 0.15);
  EXPECT_GT(thing.confidence, 0.5);
  ASSERT_TRUE(thing.velocity_known);
  EXPECT_NEAR(thing.left_m_s, 0.5 / 0.4, 0.2);
  EXPECT_NEAR(thing.forward_m_s, 0.0, 0.3);
}

TEST(Motion, ABoxThatComesNearerIsFound) {
  MotionFinder finder(on(), {});
  find(finder, look_at({box(3.5, 0.0)}, {}, {}), 0.0);
  const Found found = find(finder, look_at({box(2.9, 0.0)}, {}, {}), 0.4);
  ASSERT_EQ(found.moving.size(), 1U);
  ASSERT_TRUE(found.moving[0].velocity_known);
  EXPECT_NEAR(found.moving[0].forward_m_s, -0.6 / 0.4, 0.4);
}

TEST(Motion, ABoxThatGoesAwayIsFound) {
  MotionFinder finder(on(), {});
  find(finder, look_at({box(2.4, 0.0)}, {}, {}), 0.0);
  const Found found = find(finder, look_at({box(3.0, 0.0)}, {}, {}), 0.4);
  ASSERT_EQ(found.moving.size(), 1U);
  EXPECT_NEAR(found.moving[0].distance_m, 3.0, 0.1);
}

/// The box behind was hidden in part by the one before, which stays.
TEST(Motion, DrivingTurningTheHeadAndLookingAroundACornerMoveNothing) {
  const std::vector<Box> boxes = {box(3.0, -0.2), box(4.2, 0.3)};
  const Pose2 bases[] = {{0.3, 0.0, 0.0}, {0.2, 0.15, 0.0}, {0.0, -0.2, 0.0}};
  const HeadPose heads[] = {{0.0, 0.0}, {0.2, -0.1}, {-0.25, 0.05}};
  for (const Pose2& base : bases) {
    for (const HeadPose& head : heads) {
      MotionFinder finder(on(), {});
      find(finder, look_at(boxes, {}, {}), 0.0);
      EXPECT_TRUE(find(finder, look_at(boxes, base, head), 0.4).moving.empty())
          << base.x_m << ' ' << base.y_m << ' ' << head.pan_rad;
    }
  }
}

TEST(Motion, ATurnOfTheBaseIsTheSameAsATurnOfTheHead) {
  const std::vector<Box> boxes = {box(3.0, -0.2), box(4.2, 0.3)};
  MotionFinder finder(on(), {});
  find(finder, look_at(boxes, {}, {}), 0.0);
  Look turned = look_at(boxes, {}, {0.2, 0.0});
  turned.head.pan_rad = 0.0;  // the camera is on the axis: only the frame differs
  turned.base.heading_rad = 0.2;
  EXPECT_TRUE(find(finder, turned, 0.4).moving.empty());
}

TEST(Motion, WhatIsUnknownBeforeDoesNotMove) {
  MotionFinder finder(on(), {});
  Look before = look_at({box(3.0, -0.3)}, {}, {});
  synthetic::make_unknown(before.map, {0, 0, 160, 120});
  find(finder, before, 0.0);
  EXPECT_TRUE(find(finder, look_at({box(3.0, 0.2)}, {}, {}), 0.4).moving.empty());
}

TEST(Motion, NothingIsComparedAcrossAPauseOrAnotherSize) {
  MotionFinder finder(on(), {});
  find(finder, look_at({box(3.0, -0.3)}, {}, {}), 0.0);
  EXPECT_TRUE(find(finder, look_at({box(3.0, 0.2)}, {}, {}), 5.0).moving.empty());
  Look small = look_at({box(3.0, -0.3)}, {}, {});
  small.map = synthetic::empty_map(80, 60);
  small.grey = cv::Mat1b(60, 80, uchar{9});
  EXPECT_TRUE(find(finder, small, 5.4).moving.empty());
}

}  // namespace
}  // namespace striate::perception
