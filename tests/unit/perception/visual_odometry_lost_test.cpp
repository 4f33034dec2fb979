#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "striate/perception/visual_odometry/visual_odometry.hpp"
#include "tests/reference/rendered_room.hpp"

/// What visual odometry does where the keyframe is out of sight, in the dark, and after it.
namespace striate::perception {
namespace {

using reference::RenderedRoom;
using reference::room_pose;

const cv::Size kLostView(288, 216);

RenderedRoom dark_room() {
  RenderedRoom dark;
  dark.light = 0.0;
  return dark;
}

/// Turns about itself, a tenth of the field of view from view to view.
RigidMotion turned_so_far(int k) {
  return room_pose({0.02 * k, 0.0, 0.0}, {0.0, 0.1 * k, 0.0});
}

/// Settings under which the first view stays the keyframe as long as it is in sight at all.
VisualOdometrySettings that_keep_the_keyframe(int keyframes) {
  VisualOdometrySettings settings;
  settings.keep_share = 0.0;
  settings.keyframes = keyframes;
  return settings;
}

TEST(VisualOdometryOutOfSight, TheLastViewTakesTheKeyframesPlaceAndIsTold) {
  RenderedRoom room;
  room.noise = 1.0;
  VisualOdometry odometry(that_keep_the_keyframe(5));
  std::size_t number = 0;
  int rescued = 0;
  for (int k = 0; k <= 14; ++k) {
    const VisualPose pose = odometry.see(room.see(turned_so_far(k), kLostView, k));
    ASSERT_TRUE(pose.known() || k == 0) << k << " " << text_of(pose.reason);
    EXPECT_EQ(pose.keyframe, k == 0);
    rescued += pose.keyframe_number != number;
    number = pose.keyframe_number;
    // The motion that was measured is the one from the view that is named.
    const RigidMotion truth =
        inverse(turned_so_far(k)) * turned_so_far(static_cast<int>(pose.keyframe_number));
    EXPECT_LT(cv::norm(step_between(pose.camera_from_keyframe, truth)), 0.02) << k;
    EXPECT_LT(cv::norm(step_between(pose.world_from_camera, turned_so_far(k))), 0.03) << k;
  }
  EXPECT_GE(rescued, 1);
}

TEST(VisualOdometryOutOfSight, KeyframesAreRefinedTogetherThereToo) {
  RenderedRoom room;
  room.noise = 1.0;
  VisualOdometry refined(that_keep_the_keyframe(5)), plain(that_keep_the_keyframe(1));
  bool differ = false;
  for (int k = 0; k <= 14; ++k) {
    const StereoView view = room.see(turned_so_far(k), kLostView, k);
    const VisualPose a = refined.see(view);
    const VisualPose b = plain.see(view);
    differ = differ || a.world_from_camera.way_m != b.world_from_camera.way_m;
  }
  EXPECT_TRUE(differ);
}

TEST(VisualOdometryOutOfSight, FiftyDarkViewsAllowNoMotionThatFiveDoNot) {
  VisualOdometrySettings settings;
  settings.most_turn_rad = 0.02;
  const RenderedRoom room;
  const RenderedRoom dark = dark_room();
  for (const int dark_views : {1, 50}) {
    VisualOdometry odometry(settings);
    (void)odometry.see(room.see({}, kLostView));
    for (int k = 0; k < dark_views; ++k) {
      EXPECT_EQ(odometry.see(dark.see({}, kLostView)).reason, NoEstimate::too_little_texture);
    }
    // Six images of 0.02 rad are 0.12 rad.
    const VisualPose pose = odometry.see(room.see(room_pose({}, {0, 0.16, 0}), kLostView));
    EXPECT_EQ(pose.reason, NoEstimate::motion_too_large)
        << dark_views << " " << text_of(pose.reason);
  }
}

TEST(VisualOdometryOutOfSight, ThatTheWayIsLostIsSaidWhereItGoesOnAndOnce) {
  RenderedRoom room;
  VisualOdometry odometry({});
  (void)odometry.see(room.see({}, kLostView));
  ASSERT_TRUE(odometry.see(room.see(room_pose({0, 0, 0.05}), kLostView)).known());
  // Another camera, which sees nothing at first.
  const VisualPose nothing = odometry.see(dark_room().see({}, {400, 300}));
  EXPECT_EQ(nothing.reason, NoEstimate::too_little_texture);
  EXPECT_FALSE(nothing.begun_anew);
  EXPECT_FALSE(nothing.placed());
  const VisualPose begun = odometry.see(room.see(room_pose({0, 0, 0.1}), {400, 300}));
  EXPECT_EQ(begun.reason, NoEstimate::beginning);
  EXPECT_TRUE(begun.begun_anew);
  EXPECT_FALSE(begun.placed());
  const VisualPose next = odometry.see(room.see(room_pose({0, 0, 0.15}), {400, 300}));
  EXPECT_TRUE(next.known());
  EXPECT_FALSE(next.begun_anew);
}

}  // namespace
}  // namespace striate::perception
