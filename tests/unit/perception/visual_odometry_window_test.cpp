#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "striate/perception/visual_odometry/keyframe_window.hpp"
#include "striate/perception/visual_odometry/visual_odometry.hpp"
#include "tests/reference/rendered_room.hpp"

namespace striate::perception {
namespace {

const StereoEyes kWindowEyes{300.0, 160.0, 120.0, 0.12, 0.0};
constexpr double kWindowNoise_px = 0.2;

/// The k-th of cameras that go on a quarter of a metre at a time, and turn a little.
RigidMotion window_camera(int k) {
  return {rotation_about({0.0, -0.02 * k, 0.005 * k}), {0.01 * k, 0.0, -0.25 * k}};
}

/// What it sees of one and the same points, with noise; track t is point t.
WindowKeyframe window_frame(int k, const RigidMotion& thought) {
  std::mt19937 places(7);
  std::mt19937 random(static_cast<unsigned>(100 + k));
  std::uniform_real_distribution<double> x_m(-1.5, 1.5), y_m(-1.0, 1.0), z_m(3.0, 9.0);
  std::normal_distribution<double> normal(0.0, kWindowNoise_px);
  WindowKeyframe frame{thought, {}};
  for (std::int64_t track = 0; track < 120; ++track) {
    const cv::Vec3d point_m(x_m(places), y_m(places), z_m(places));
    StereoSight sight = sight_of(kWindowEyes, window_camera(k) * point_m);
    for (int i = 0; i < 3; ++i) sight[i] += normal(random);
    frame.sights.push_back({track, sight, 1.0});
  }
  return frame;
}

TEST(KeyframeWindowTest, PosesThatAreOffComeBackAndTheOldestStays) {
  KeyframeWindow window(5);
  for (int k = 0; k < 4; ++k) {
    const cv::Vec6d off(0.02, -0.01, 0.03, 0.004, -0.003, 0.002);
    window.add(window_frame(k, nudged(window_camera(k), off * static_cast<double>(k))));
  }
  const double before = cv::norm(step_between(window.newest().camera_from_world, window_camera(3)));
  window.refine(kWindowEyes, kWindowNoise_px);
  const double after = cv::norm(step_between(window.newest().camera_from_world, window_camera(3)));
  EXPECT_LT(after, 0.1 * before);
  ASSERT_EQ(window.places().size(), 120U);
  EXPECT_EQ(window.places().at(0).sights, 4);
}

TEST(KeyframeWindowTest, HoldsNoMoreThanItMayAndAloneChangesNothing) {
  KeyframeWindow window(2);
  const RigidMotion thought = nudged(window_camera(0), {0.02, 0, 0, 0, 0, 0});
  window.add(window_frame(0, thought));
  window.refine(kWindowEyes, kWindowNoise_px);
  EXPECT_TRUE(window.places().empty());
  EXPECT_EQ(window.newest().camera_from_world.way_m, thought.way_m);
  for (int k = 1; k < 4; ++k) window.add(window_frame(k, window_camera(k)));
  window.refine(kWindowEyes, kWindowNoise_px);
  EXPECT_EQ(window.places().at(0).sights, 2);
  window.clear();
  window.add(window_frame(0, thought));
  window.refine(kWindowEyes, kWindowNoise_px);
  EXPECT_TRUE(window.places().empty());
}

/// Where the last of 21 views is thought to be, and how far that is off.
std::pair<VisualPose, double> end_of_a_way(int keyframes) {
  reference::RenderedRoom room;
  room.noise = 2.0;
  VisualOdometrySettings settings;
  settings.keyframes = keyframes;
  settings.keep_share = 0.9;  // many keyframes
  VisualOdometry odometry(settings);
  VisualPose pose;
  RigidMotion truth;
  for (int k = 0; k <= 20; ++k) {
    truth = reference::room_pose({0.02 * k, 0.0, 0.08 * k}, {0, 0.01 * k, 0});
    pose = odometry.see(room.see(truth, {288, 216}, k));
    EXPECT_TRUE(pose.known() || k == 0) << k;
  }
  return {pose, cv::norm(pose.world_from_camera.way_m - truth.way_m)};
}

TEST(KeyframeWindowTest, AWayIsFollowedWithFiveKeyframesTogetherAndWithEachByItself) {
  const auto [five, five_off_m] = end_of_a_way(5);
  const auto [one, one_off_m] = end_of_a_way(1);
  EXPECT_LT(five_off_m, 0.01);
  EXPECT_LT(one_off_m, 0.01);
  EXPECT_NE(five.world_from_camera.way_m, one.world_from_camera.way_m);  // they were refined
}

}  // namespace
}  // namespace striate::perception
