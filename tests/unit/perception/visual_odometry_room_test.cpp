#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "striate/perception/visual_odometry/visual_odometry.hpp"
#include "tests/reference/rendered_room.hpp"

namespace striate::perception {
namespace {

using reference::RenderedRoom;
using reference::room_pose;

const cv::Size kRoomView(288, 216);

/// A bend forward through the room, head swaying.
RigidMotion on_the_way(int k) {
  const double t = 0.1 * k;
  return room_pose({0.3 * std::sin(t), 0.03 * std::sin(2.0 * t), 0.8 * t},
                   {0.01 * std::sin(3.0 * t), 0.15 * std::sin(t), 0.02 * std::sin(2.0 * t)});
}

double place_error_m(const VisualPose& pose, const RigidMotion& truth) {
  return cv::norm(pose.world_from_camera.way_m - truth.way_m);
}

double turn_error_rad(const VisualPose& pose, const RigidMotion& truth) {
  return cv::norm(turn_of(truth.rotation.t() * pose.world_from_camera.rotation));
}

TEST(VisualOdometryTest, FollowsAWayThroughARoom) {
  RenderedRoom room;
  room.noise = 1.5;
  VisualOdometry odometry({});
  VisualPose pose;
  int keyframes = 0;
  for (int k = 0; k <= 25; ++k) {
    pose = odometry.see(room.see(on_the_way(k), kRoomView, k));
    EXPECT_TRUE(pose.known() || k == 0) << k << " " << text_of(pose.reason);
    EXPECT_FALSE(pose.begun_anew);
    keyframes += pose.keyframe;
  }
  EXPECT_GE(keyframes, 3);  // it does not all hang on the first one
  // Two metres of way: one percent, and a tenth of a degree a metre.
  EXPECT_LT(place_error_m(pose, on_the_way(25)), 0.02);
  EXPECT_LT(turn_error_rad(pose, on_the_way(25)), 0.0035);
}

TEST(VisualOdometryTest, ACameraThatStandsDoesNotDrift) {
  const StereoView clean = RenderedRoom().see({}, kRoomView);
  VisualOdometry odometry({});
  double early_m = 0.0, late_m = 0.0;
  for (int k = 0; k <= 40; ++k) {
    const VisualPose pose = odometry.see(reference::with_noise(clean, 2.0, k + 1));
    ASSERT_TRUE(pose.known() || k == 0);
    EXPECT_FALSE(pose.keyframe && k > 0);
    (k <= 20 ? early_m : late_m) = std::max(k <= 20 ? early_m : late_m, place_error_m(pose, {}));
  }
  EXPECT_LT(early_m, 0.004);
  EXPECT_LT(late_m, 0.004);
}

TEST(VisualOdometryTest, TellsWhyThereIsNoEstimateAndFindsItselfAgain) {
  RenderedRoom room;
  RenderedRoom dark = room;
  dark.light = 0.01;
  dark.noise = 1.0;
  VisualOdometry odometry({});
  EXPECT_EQ(odometry.see(dark.see({}, kRoomView)).reason, NoEstimate::too_little_texture);
  EXPECT_EQ(odometry.see(room.see({}, kRoomView)).reason, NoEstimate::beginning);
  EXPECT_EQ(odometry.see(dark.see({}, kRoomView)).reason, NoEstimate::too_little_texture);
  StereoView exchanged = room.see({}, kRoomView);
  std::swap(exchanged.left, exchanged.right);
  EXPECT_EQ(odometry.see(exchanged).reason, NoEstimate::eyes_disagree);
  StereoView elsewhere = room.see({}, kRoomView);
  elsewhere.right = room.see(room_pose({0, 0, 2}, {0, 2, 0}), kRoomView).right;
  EXPECT_EQ(odometry.see(elsewhere).reason, NoEstimate::eyes_disagree);
  const VisualPose away = odometry.see(room.see(room_pose({0, 0, 2}, {0, 2.5, 0}), kRoomView));
  EXPECT_TRUE(away.reason == NoEstimate::too_few_matches || away.reason == NoEstimate::no_agreement)
      << text_of(away.reason);
  const VisualPose again = odometry.see(room.see(room_pose({0, 0, 0.1}), kRoomView));
  EXPECT_TRUE(again.known()) << text_of(again.reason);
  EXPECT_LT(place_error_m(again, room_pose({0, 0, 0.1})), 0.005);
}

TEST(VisualOdometryTest, ABlankWallWithNoiseIsNoEstimate) {
  RenderedRoom blank;
  blank.contrast = 0.0;
  blank.boxes.clear();
  blank.noise = 3.0;
  VisualOdometry odometry({});
  for (int k = 0; k < 5; ++k) {
    const VisualPose pose = odometry.see(blank.see(room_pose({0, 0, 0.05 * k}), kRoomView, k));
    EXPECT_EQ(pose.reason, NoEstimate::too_little_texture) << text_of(pose.reason);
  }
}

TEST(VisualOdometryTest, BeginsAnewWhereItIsLostAndSaysSo) {
  RenderedRoom room;
  VisualOdometrySettings settings;
  settings.most_lost = 2;
  VisualOdometry odometry(settings);
  (void)odometry.see(room.see({}, kRoomView));
  const RigidMotion away = room_pose({0, 0, 2}, {0, 2.5, 0});
  int begun = 0;
  for (int k = 0; k < 3; ++k) {
    const VisualPose pose = odometry.see(room.see(away, kRoomView, k));
    EXPECT_FALSE(pose.known());
    begun += pose.begun_anew;
  }
  EXPECT_EQ(begun, 1);
  const VisualPose next = odometry.see(room.see(away * room_pose({0, 0, 0.05}), kRoomView));
  ASSERT_TRUE(next.known()) << text_of(next.reason);
  EXPECT_LT(place_error_m(next, room_pose({0, 0, 0.05})), 0.005);
}

TEST(VisualOdometryTest, LightThatChangesAndPicturesThatAreMissingDoNotThrowItOff) {
  RenderedRoom room;
  room.noise = 1.0;
  VisualOdometry odometry({});
  VisualPose pose;
  for (int k = 0; k <= 24; k += 3) {
    room.light = k % 2 == 0 ? 0.5 : 1.2;
    pose = odometry.see(room.see(on_the_way(k), kRoomView, k));
    EXPECT_TRUE(pose.known() || k == 0) << k << " " << text_of(pose.reason);
  }
  EXPECT_LT(place_error_m(pose, on_the_way(24)), 0.03);
}

TEST(VisualOdometryTest, SomethingThatMovesByItselfDoesNotCarryItAway) {
  RenderedRoom room;
  VisualOdometry odometry({});
  VisualPose pose;
  int most_on_it = 0;  // points that are seen again and go another way
  for (int k = 0; k <= 12; ++k) {
    RenderedRoom with = room;
    const double x = -2.0 + 0.15 * k;
    with.boxes.push_back({{x, -0.9, 2.6}, {x + 0.9, 1.2, 3.0}, 21});
    pose = odometry.see(with.see(on_the_way(k), kRoomView, k));
    EXPECT_TRUE(pose.known() || k == 0) << text_of(pose.reason);
    most_on_it = std::max(most_on_it, pose.matches - pose.agreeing);
  }
  EXPECT_GT(most_on_it, 20);
  EXPECT_LT(place_error_m(pose, on_the_way(12)), 0.02);
}

TEST(VisualOdometryTest, ItsCovarianceHoldsForPicturesWithNoise) {
  const RenderedRoom room;
  constexpr int kPairs = 25;
  const RigidMotion step = room_pose({0.03, 0.0, 0.12}, {0.0, 0.02, 0.005});
  const StereoView here = room.see({}, kRoomView);
  const StereoView there = room.see(step, kRoomView);
  double sum = 0.0;
  for (int seed = 1; seed <= kPairs; ++seed) {
    VisualOdometry odometry({});
    (void)odometry.see(reference::with_noise(here, 2.5, 2 * seed));
    const VisualPose pose = odometry.see(reference::with_noise(there, 2.5, 2 * seed + 1));
    ASSERT_TRUE(pose.known());
    const cv::Vec6d error = step_between(pose.camera_from_keyframe, inverse(step));
    const cv::Matx66d information = pose.covariance.inv(cv::DECOMP_CHOLESKY);
    sum += error.dot(information * error);
  }
  // Six is right; patches err a little more alike than chance has it.
  EXPECT_GT(sum / kPairs, 3.0);
  EXPECT_LT(sum / kPairs, 12.0);
}

TEST(VisualOdometryTest, TheSameViewsGiveTheSameBitsAndNothingOfTheCallerIsKept) {
  RenderedRoom room;
  room.noise = 1.0;
  VisualOdometry a({}), b({});
  for (int k = 0; k <= 8; ++k) {
    StereoView view = room.see(on_the_way(3 * k), kRoomView, k);
    StereoView copy = view;
    copy.left = view.left.clone();
    copy.right = view.right.clone();
    const VisualPose one = a.see(view);
    view.left.setTo(0);
    view.right.setTo(0);
    const VisualPose other = b.see(copy);
    EXPECT_EQ(one.world_from_camera.way_m, other.world_from_camera.way_m);
    EXPECT_EQ(one.world_from_camera.rotation, other.world_from_camera.rotation);
    EXPECT_EQ(one.covariance, other.covariance);
    EXPECT_EQ(one.reason, other.reason);
  }
}

TEST(VisualOdometryTest, AnotherSizeOrCameraBeginsAnew) {
  RenderedRoom room;
  VisualOdometry odometry({});
  (void)odometry.see(room.see({}, kRoomView));
  ASSERT_TRUE(odometry.see(room.see(room_pose({0, 0, 0.05}), kRoomView)).known());
  VisualPose pose = odometry.see(room.see(room_pose({0, 0, 0.1}), {400, 300}));
  EXPECT_TRUE(pose.begun_anew);
  EXPECT_FALSE(pose.known());
  EXPECT_TRUE(odometry.see(room.see(room_pose({0, 0, 0.15}), {400, 300})).known());
  StereoView other = room.see(room_pose({0, 0, 0.2}), {400, 300});
  other.eyes.focal_px *= 1.1;
  EXPECT_TRUE(odometry.see(other).begun_anew);
}

TEST(VisualOdometryTest, RefusesACameraThatIsNoneAndChangesNothing) {
  RenderedRoom room;
  VisualOdometry odometry({});
  (void)odometry.see(room.see({}, kRoomView));
  const StereoView good = room.see(room_pose({0, 0, 0.05}), kRoomView);
  const double none = std::nan("");
  for (const double odd : {none, 0.0, -1.0, HUGE_VAL}) {
    StereoView view = good;
    view.eyes.focal_px = odd;
    EXPECT_THROW((void)odometry.see(view), std::invalid_argument) << odd;
    view = good;
    view.eyes.baseline_m = odd;
    EXPECT_THROW((void)odometry.see(view), std::invalid_argument) << odd;
  }
  StereoView view = good;
  view.eyes.doffs_px = none;
  EXPECT_THROW((void)odometry.see(view), std::invalid_argument);
  view = good;
  view.right = cv::Mat1b(100, 100);
  EXPECT_THROW((void)odometry.see(view), std::invalid_argument);
  EXPECT_THROW((void)odometry.see({}), std::invalid_argument);
  EXPECT_TRUE(odometry.see(good).known());
}

TEST(VisualOdometryTest, OddPicturesAreNoEstimateAndDoNoHarm) {
  const StereoView seen = RenderedRoom().see({}, kRoomView);
  VisualOdometry odometry({});
  for (const cv::Size size : {cv::Size(1, 1), {2, 300}, {300, 2}, {17, 13}, {40, 30}, {64, 48}}) {
    for (int fill : {0, 128, 255}) {
      StereoView view = seen;
      view.left = cv::Mat1b(size, static_cast<std::uint8_t>(fill));
      view.right = view.left.clone();
      EXPECT_FALSE(odometry.see(view).known());
      cv::theRNG().state = 7;
      cv::randu(view.left, 0, 256);
      cv::randu(view.right, 0, 256);
      EXPECT_FALSE(odometry.see(view).known());
      view.right = view.left.clone();
      EXPECT_FALSE(odometry.see(view).known());
    }
  }
}

TEST(VisualOdometryTest, WorksAtTheWidthThatItIsTold) {
  RenderedRoom room;
  VisualOdometrySettings settings;
  settings.width_px = 240;
  VisualOdometry odometry(settings);
  VisualPose pose;
  for (int k = 0; k <= 10; ++k) pose = odometry.see(room.see(on_the_way(k), {480, 360}, k));
  ASSERT_TRUE(pose.known());
  EXPECT_LT(place_error_m(pose, on_the_way(10)), 0.02);
}

}  // namespace
}  // namespace striate::perception
