#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "striate/perception/corridor/ray_of.hpp"
#include "striate/perception/corridor/vanishing_point.hpp"
#include "striate/perception/corridor/wall_profile.hpp"
#include "striate/perception/motion/place_verdict.hpp"
#include "striate/perception/obstacles/column_scan.hpp"
#include "striate/perception/perception.hpp"
#include "striate/perception/recognition/look_windows.hpp"
#include "striate/perception/recognition/region_depth.hpp"
#include "tests/unit/perception/obstacles_synthetic_room.hpp"

/// Stages that make an index of what a camera says of itself, with cameras that no robot has.
/// Nobody may hand them on (platform/interface/plausible.hpp); if somebody does, nothing is read or
/// written that is not there. The sanitizers are the judges.
namespace striate::perception {
namespace {

using synthetic::look;
using synthetic::Room;

const double kNone = std::nan("");
constexpr double kInfinity = std::numeric_limits<double>::infinity();

StereoFrame textured_frame(double focal_px) {
  StereoFrame frame;
  frame.left = cv::Mat3b(120, 160);
  frame.right = cv::Mat3b(120, 160);
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const auto grey = [&](int at) {
        return static_cast<uchar>(128 + 100 * synthetic::noise(v / 3 * 977 + at / 3));
      };
      frame.left(v, u) = cv::Vec3b::all(grey(u));
      frame.right(v, u) = cv::Vec3b::all(grey(u + 12));
    }
  }
  frame.focal_px = focal_px;
  frame.centre_u_px = 79.5;
  frame.centre_v_px = 59.5;
  frame.baseline_m = 0.12;
  return frame;
}

TEST(OddCameras, AWideOneThatLooksDownHasRowsThatLookBehind) {
  // 132 degrees wide and 30 degrees down: its lowest rows look behind the robot.
  RobotDescription robot;
  robot.camera_height_m = 1.0;
  StereoFrame frame = textured_frame(35.5);
  for (const double tilt_rad : {-0.52, -1.0, 0.52, 1.0}) {
    frame.head.tilt_rad = tilt_rad;
    EXPECT_TRUE(Perception({}, robot).see(frame).valid);
  }
  const DisparityMap map = look(Room{}, {});
  DisparityMap wide = map;
  wide.focal_px = 20.0;
  const ViewGeometry geometry(wide, {0.0, -0.52}, robot);
  ASSERT_LT(geometry.level_factor(119.0), 0.0);
  const JudgedMap judged = judge_pixels(wide, geometry, {}, 0.0);
  for (int u = 0; u < 160; ++u) {
    EXPECT_EQ(static_cast<PixelKind>(judged.kind(119, u)), PixelKind::unknown);
  }
}

TEST(OddCameras, NoNumberOfACameraMakesTheWholeChainWriteOutside) {
  for (const double odd : {0.0, 1e-300, 1e-3, 0.5, 2.0, 4e6, 1e300, kInfinity, kNone}) {
    for (const auto number : {&StereoFrame::focal_px, &StereoFrame::baseline_m,
                              &StereoFrame::centre_u_px, &StereoFrame::centre_v_px}) {
      StereoFrame frame = textured_frame(203.0);
      frame.*number = odd;
      frame.head.tilt_rad = -0.3;
      EXPECT_TRUE(Perception({}, {}).see(frame).valid) << odd;
    }
  }
  for (const double odd : {-1e300, -1.57, 1.57, 1e300, kInfinity, kNone}) {
    StereoFrame frame = textured_frame(203.0);
    frame.head.tilt_rad = odd;
    EXPECT_TRUE(Perception({}, {}).see(frame).valid) << odd;
    frame.head = {odd, 0.0};
    EXPECT_TRUE(Perception({}, {}).see(frame).valid) << odd;
  }
}

TEST(OddCameras, VotesForVanishingPointsStayInTheirBins) {
  const std::vector<EdgePoint> edges = {{10.0F, 20.0F, 0.6F, 0.8F, 1.0F},
                                        {150.0F, 100.0F, -0.6F, 0.8F, 1.0F},
                                        {1e30F, -1e30F, 0.1F, 0.99F, 1.0F}};
  for (const double odd : {-1e300, -1e9, 1e9, 1e300, kInfinity, kNone}) {
    for (const VanishingSearch& search :
         {VanishingSearch{odd, -100.0, 200.0, {}}, VanishingSearch{60.0, -odd, odd, {}},
          VanishingSearch{60.0, odd, 200.0, {}}, VanishingSearch{60.0, -100.0, odd, {}},
          VanishingSearch{60.0, -100.0, 200.0, {odd}}}) {
      EXPECT_LE(find_vanishing_points(edges, search).size(), 7U) << odd;
    }
  }
}

TEST(OddCameras, ARayIsOneOfItsDegrees) {
  for (const float odd : {0.0F, 1e-40F, 1e30F, std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN()}) {
    for (const float other : {odd, -odd, 1.0F, -1.0F, 0.0F}) {
      for (const int ray : {ray_of(odd, other), ray_of(other, odd), ray_of(-odd, other)}) {
        EXPECT_GE(ray, 0);
        EXPECT_LT(ray, kRays);
      }
    }
  }
}

TEST(OddCameras, PointsThatAreNoneAreNoWall) {
  std::vector<SpacePoint> points;
  for (const double odd : {-1e300, 0.0, 1.0, 1e12, 1e300, kInfinity, kNone}) {
    for (const double other : {-1e300, 0.5, 3.0, kInfinity, kNone}) {
      points.push_back({odd, other, 1.0});
      points.push_back({other, odd, 1.0});
      points.push_back({other, 1.0, odd});
    }
  }
  for (const double heading_rad : {0.0, 1.0, kNone}) {
    EXPECT_EQ(find_walls(points, heading_rad).structure(), 0.0);
  }
}

TEST(OddCameras, BoxesFarOutsideOfTheImageHaveNoDepthAndNoWindow) {
  const DisparityMap map = look(Room{}, {});
  std::vector<float> buffer;
  LookWindows windows;
  windows.begin({160, 120}, 4);
  for (const double odd : {-1e300, -1e10, 1e10, 1e300, kInfinity, kNone}) {
    EXPECT_EQ(median_disparity_px(map, {odd, 0.0, 10.0, 10.0}, buffer), 0.0) << odd;
    (void)median_disparity_px(map, {0.0, 0.0, odd, 10.0}, buffer);
    windows.add({odd, 0.0, 10.0, 10.0});
    windows.add({0.0, odd, odd, 10.0});
  }
  for (const LookWindow& window : windows.windows()) {
    EXPECT_EQ((window.part & cv::Rect(0, 0, 160, 120)), window.part);
  }
}

}  // namespace
}  // namespace striate::perception
