#include "striate/platform/simulator/eye_faults.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "striate/platform/simulator/render/lens_faults.hpp"
#include "tests/unit/simulator/render_world.hpp"

namespace striate::simulator::test {
namespace {

using render::Eye;
using render::EyeMotion;
using render::LensFaults;
using render::V4;

StereoFrame frame_with(const EyeFaults& faults, const CameraSettings& camera = clean_camera()) {
  World world = bright_corridor();
  world.posters = {{Side::left, 6.0, 1.4, 0.8, 1.1, "poster_map"},
                   {Side::right, 7.5, 1.3, 0.8, 1.1, "poster_fish"}};
  world.eyes = faults;
  Renderer renderer(world, build_floor_plan(world), camera, 5);
  return renderer.image(standing_at(3.0, 0.1, 2.0));
}

/// How far `b` lies from `a` across (or down), in whole pixels, where they agree best.
int shift_between(const cv::Mat3b& a, const cv::Mat3b& b, bool down) {
  int best = 0;
  double least = 1e18;
  for (int k = -6; k <= 6; ++k) {
    const int du = down ? 0 : k;
    const int dv = down ? k : 0;
    const cv::Rect in_a(10, 10, a.cols - 20, a.rows - 20);
    const double differ = cv::norm(a(in_a), b(in_a + cv::Point(du, dv)), cv::NORM_L1);
    if (differ < least) {
      least = differ;
      best = k;
    }
  }
  return best;
}

std::vector<V4> flat_light(const CameraSettings& camera, float level = 1.0F) {
  return std::vector<V4>(static_cast<std::size_t>(camera.width_px * camera.height_px()),
                         render::splat(level));
}

TEST(EyeFaults, ThatAreOffLeaveTheLightAlone) {
  const CameraSettings camera = clean_camera();
  LensFaults lens({}, camera, Eye::left, 5);
  const std::vector<V4> light = flat_light(camera);
  EXPECT_EQ(&lens.apply(light, {1.0, 0.01, 0.5, 0.2}), &light) << "not even a copy";
}

TEST(EyeFaults, OfCalibrationChangeWhatIsSeenAndNotWhatIsTold) {
  const StereoFrame right = frame_with({});
  EyeFaults faults;
  faults.focal = 0.02;
  faults.baseline = 0.05;
  const StereoFrame wrong = frame_with(faults);
  EXPECT_NEAR(wrong.focal_px, right.focal_px, 1e-4);
  EXPECT_EQ(right.focal_px, static_cast<double>(static_cast<float>(right.focal_px)))
      << "without a fault it is the view's own number";
  EXPECT_EQ(wrong.baseline_m, right.baseline_m);
  EXPECT_EQ(wrong.head.tilt_rad, right.head.tilt_rad);
  EXPECT_FALSE(same(wrong.left, right.left));
}

TEST(EyeFaults, OfYawMoveTheRightImageAlone) {
  const StereoFrame straight = frame_with({});
  EyeFaults faults;
  faults.yaw_rad = 3.0 / straight.focal_px;  // three pixels to the left: the scene goes right
  const StereoFrame turned = frame_with(faults);
  EXPECT_TRUE(same(turned.left, straight.left));
  EXPECT_EQ(shift_between(straight.right, turned.right, false), 3);
}

TEST(EyeFaults, OfRowsLiftTheRightImageAlone) {
  const StereoFrame straight = frame_with({});
  EyeFaults faults;
  faults.rows_px = 2.0;
  const StereoFrame lifted = frame_with(faults);
  EXPECT_TRUE(same(lifted.left, straight.left));
  EXPECT_EQ(shift_between(straight.right, lifted.right, true), -2);
}

TEST(EyeFaults, OfTiltMoveBothImages) {
  const StereoFrame straight = frame_with({});
  EyeFaults faults;
  faults.tilt_rad = 3.0 / straight.focal_px;  // looks up: the scene goes down
  const StereoFrame tilted = frame_with(faults);
  EXPECT_EQ(shift_between(straight.left, tilted.left, true), 3);
  EXPECT_EQ(shift_between(straight.right, tilted.right, true), 3);
}

/// Where a row becomes bright, in pixels.
double edge_in_row(const std::vector<V4>& light, int width, int y) {
  double dark = 0.0;
  for (int x = 0; x < width; ++x) {
    dark += 1.0 - static_cast<double>(light[static_cast<std::size_t>(y * width + x)][1]);
  }
  return dark;
}

TEST(EyeFaults, OfARollingShutterLetUprightEdgesLeanWhileTheHeadTurns) {
  const CameraSettings camera = clean_camera();
  EyeFaults faults;
  faults.rolling_shutter_s = 0.03;
  std::vector<V4> light = flat_light(camera);
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (static_cast<int>(i) % camera.width_px < 80) light[i] = V4{};
  }
  const int last = camera.height_px() - 1;
  LensFaults lens(faults, camera, Eye::left, 5);
  EXPECT_EQ(&lens.apply(light, {1.0, 0.01, 0.0, 0.0}), &light) << "who stands sees no such thing";
  const std::vector<V4>& leaning = lens.apply(light, {1.0, 0.01, 1.0, 0.0});
  const double focal_px = 80.0 / std::tan(camera.field_rad / 2.0);
  // Turning left the scene goes to the right: rows that are read later show it farther right.
  EXPECT_NEAR(
      edge_in_row(leaning, camera.width_px, last) - edge_in_row(leaning, camera.width_px, 0),
      focal_px * 0.03, 0.2);
}

TEST(EyeFaults, OfDistortionMoveTheCornersAndNotTheMiddle) {
  const CameraSettings camera = clean_camera();
  EyeFaults faults;
  faults.distortion = 0.05;
  std::vector<V4> light = flat_light(camera);
  for (std::size_t i = 0; i < light.size(); ++i) {
    light[i] = render::splat(static_cast<float>(static_cast<int>(i) % camera.width_px));
  }
  LensFaults lens(faults, camera, Eye::left, 5);
  const std::vector<V4>& bent = lens.apply(light, {});
  const auto at = [&](int x, int y) {
    return static_cast<double>(bent[static_cast<std::size_t>(y * camera.width_px + x)][1]);
  };
  EXPECT_NEAR(at(80, 60), 80.0, 0.1);
  EXPECT_NEAR(at(20, 60), 79.5 - 59.5 * (1.0 + 0.05 * 59.5 * 59.5 / (79.5 * 79.5 + 59.5 * 59.5)),
              0.1)
      << "what is seen there lies farther out: a barrel";
}

TEST(EyeFaults, OfLampsThatFlickerBandTheImageOfARollingShutter) {
  const CameraSettings camera = clean_camera();
  EyeFaults faults;
  faults.lamp_flicker = 0.3;
  faults.rolling_shutter_s = 0.02;  // two periods
  const auto spread_of = [&](double shutter_s) {
    LensFaults lens(faults, camera, Eye::left, 5);
    const std::vector<V4> light = flat_light(camera);
    const std::vector<V4>& banded = lens.apply(light, {1.0, shutter_s, 0.0, 0.0});
    float low = 10.0F;
    float high = 0.0F;
    for (const V4& pixel : banded) {
      low = std::min(low, pixel[1]);
      high = std::max(high, pixel[1]);
    }
    return static_cast<double>(high - low);
  };
  EXPECT_NEAR(spread_of(0.0005), 0.6, 0.02);
  EXPECT_LT(spread_of(1.0 / 99.94), 0.01) << "a whole period evens it out";
}

TEST(EyeFaults, OfDirtCoverTheirShareOfOneLens) {
  const CameraSettings camera = clean_camera();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    EyeFaults faults;
    faults.dirt = 0.08;
    int dirty = 0;
    for (const Eye eye : {Eye::left, Eye::right}) {
      LensFaults lens(faults, camera, eye, seed);
      const std::vector<V4> light = flat_light(camera);
      double lost = 0.0;
      for (const V4& pixel : lens.apply(light, {})) lost += 1.0 - static_cast<double>(pixel[1]);
      // A covered pixel loses 1 - 0.35 - 0.12 of its light.
      const double covered = lost / 0.53 / static_cast<double>(light.size());
      if (covered < 1e-6) continue;
      ++dirty;
      EXPECT_GE(covered, 0.079);
      EXPECT_LE(covered, 0.16) << "the last blot may reach over";
    }
    EXPECT_EQ(dirty, 1);
  }
}

TEST(EyeFaults, OfWhiteBalanceReddenTheImage) {
  EyeFaults faults;
  faults.white_balance = 0.2;
  const cv::Scalar before = cv::mean(frame_with({}).left);
  const cv::Scalar after = cv::mean(frame_with(faults).left);
  EXPECT_GT(after[2] / after[1], before[2] / before[1] * 1.04);
  EXPECT_LT(after[0] / after[1], before[0] / before[1] * 0.96);
}

TEST(EyeFaults, OfAFixedPatternAreTheSameInBothEyes) {
  EyeFaults faults;
  faults.fixed_pattern = 0.05;
  const StereoFrame plain = frame_with({});
  const StereoFrame patterned = frame_with(faults);
  cv::Mat left;
  cv::Mat right;
  cv::subtract(patterned.left, plain.left, left, cv::noArray(), CV_32F);
  cv::subtract(patterned.right, plain.right, right, cv::noArray(), CV_32F);
  const double together = left.dot(right) / std::sqrt(left.dot(left) * right.dot(right));
  EXPECT_GT(together, 0.8);
}

}  // namespace
}  // namespace striate::simulator::test
