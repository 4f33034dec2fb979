#include <gtest/gtest.h>

#include <random>

#include "striate/perception/visual_odometry/bundle.hpp"
#include "striate/perception/visual_odometry/motion_estimate.hpp"

namespace striate::perception {
namespace {

const StereoEyes kTestEyes{300.0, 160.0, 120.0, 0.12, 0.0};
const RigidMotion kTestMotion{rotation_about({0.02, -0.05, 0.01}), {0.1, -0.02, -0.35}};

struct SightNoise {
  double px = 0.0;
  double wrong_share = 0.0;  ///< of the sights, which are anywhere
};

/// Points before the camera, seen then and now; then with an error of the disparity alone, since a
/// point is where its patch was taken.
/// @param right which of them are no wrong ones, where it is asked for
std::vector<MotionSight> scattered_sights(int count, int seed, const SightNoise& noise,
                                          std::vector<char>* right = nullptr) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> u(10.0, 310.0), v(10.0, 230.0), disparity(3.0, 30.0),
      share(0.0, 1.0);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<MotionSight> sights;
  while (static_cast<int>(sights.size()) < count) {
    StereoSight then(u(random), v(random), disparity(random));
    const cv::Vec3d true_point = point_of(kTestEyes, then);
    StereoSight now = sight_of(kTestEyes, kTestMotion * true_point);
    then[2] += noise.px * normal(random);
    for (int k = 0; k < 3; ++k) now[k] += noise.px * normal(random);
    const bool wrong = share(random) < noise.wrong_share;
    if (wrong) now = {u(random), v(random), disparity(random)};
    if (then[2] < 1.0) continue;
    if (right != nullptr) right->push_back(wrong ? 0 : 1);
    sights.push_back({point_of(kTestEyes, then), then[2], 1.0, now, 1.0});
  }
  return sights;
}

double normalised_error(const MotionEstimate& estimate) {
  const cv::Vec6d error = step_between(estimate.now_from_then, kTestMotion);
  cv::Matx66d information;
  EXPECT_TRUE(invert(estimate.covariance, information));
  return error.dot(information * error);
}

TEST(RigidMotion, IsNudgedByTheStepThatLiesBetween) {
  for (const double angle : {0.0, 1e-9, 0.3, 2.0, 3.1}) {
    const cv::Vec3d axis = cv::normalize(cv::Vec3d(0.3, -0.7, 0.2));
    const RigidMotion a{rotation_about(axis * angle), {1.0, -2.0, 0.5}};
    EXPECT_NEAR(cv::norm(turn_of(a.rotation) - axis * angle), 0.0, 1e-9) << angle;
    const cv::Vec6d given(0.1, 0.2, -0.3, 0.02, -0.01, 0.03);
    const RigidMotion b = nudged(a, given);
    const cv::Vec6d step = step_between(b, a);
    const RigidMotion again = nudged(a, step);
    EXPECT_LT(cv::norm(step - given), 1e-9) << angle;
    EXPECT_LT(cv::norm(again.rotation - b.rotation), 1e-9);
    EXPECT_LT(cv::norm(again.way_m - b.way_m), 1e-9);
    EXPECT_LT(cv::norm((inverse(a) * (a * cv::Vec3d(1, 2, 3))) - cv::Vec3d(1, 2, 3)), 1e-12);
  }
}

TEST(VisualMotion, IsFoundExactlyFromExactSights) {
  const auto sights = scattered_sights(60, 1, {});
  const RigidMotion nothing;
  const MotionEstimate found = find_motion(sights, kTestEyes, nothing, {});
  ASSERT_TRUE(found.found);
  EXPECT_EQ(found.agreeing, 60);
  const MotionEstimate refined = refine_motion(sights, kTestEyes, found.now_from_then, {});
  ASSERT_TRUE(refined.found);
  EXPECT_LT(cv::norm(step_between(refined.now_from_then, kTestMotion)), 1e-9);
}

TEST(VisualMotion, IsFoundAmongAsManyWrongSightsAndTellsThem) {
  for (int seed = 1; seed <= 20; ++seed) {
    std::vector<char> right;
    const auto sights = scattered_sights(150, seed, {0.3, 0.5}, &right);
    const RigidMotion nothing;
    const MotionEstimate found = find_motion(sights, kTestEyes, nothing, {});
    ASSERT_TRUE(found.found);
    const MotionEstimate refined = refine_motion(sights, kTestEyes, found.now_from_then, {});
    ASSERT_TRUE(refined.found);
    const cv::Vec6d error = step_between(refined.now_from_then, kTestMotion);
    EXPECT_LT(cv::norm(error), 0.02) << seed;
    EXPECT_NEAR(refined.agreeing, 75, 25) << seed;
    // Of the right ones one in a hundred lies beyond the limit; a wrong one may be right by chance.
    int taken_for_wrong = 0, taken_for_right = 0;
    for (std::size_t k = 0; k < sights.size(); ++k) {
      taken_for_wrong += right[k] != 0 && refined.agrees[k] == 0;
      taken_for_right += right[k] == 0 && refined.agrees[k] != 0;
    }
    EXPECT_LE(taken_for_wrong, 8) << seed;
    EXPECT_LE(taken_for_right, 3) << seed;
  }
}

TEST(VisualMotion, ItsCovarianceIsConsistent) {
  constexpr int kSeeds = 300;
  double sum = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const auto sights = scattered_sights(80, seed, {0.25, 0.0});
    const RigidMotion nothing;
    const MotionEstimate found = find_motion(sights, kTestEyes, nothing, {});
    const MotionEstimate refined = refine_motion(sights, kTestEyes, found.now_from_then, {});
    ASSERT_TRUE(refined.found);
    sum += normalised_error(refined);
  }
  // The mean of 300 draws of chi squared with 6 degrees of freedom: 6 +- 0.2; the noise is
  // estimated, and Cauchy's weights cost a little.
  EXPECT_GT(sum / kSeeds, 5.2);
  EXPECT_LT(sum / kSeeds, 7.2);
}

TEST(VisualMotion, WithoutPointsEnoughOrOnOneRayThereIsNone) {
  const RigidMotion nothing;
  EXPECT_FALSE(find_motion({}, kTestEyes, nothing, {}).found);
  EXPECT_FALSE(refine_motion({}, kTestEyes, nothing, {}).found);
  const auto two = scattered_sights(2, 1, {});
  EXPECT_FALSE(find_motion(two, kTestEyes, nothing, {}).found);
  const std::vector<MotionSight> one_point(30, scattered_sights(1, 1, {}).front());
  EXPECT_FALSE(refine_motion(one_point, kTestEyes, nothing, {}).found);
}

TEST(VisualMotion, TheSameSightsGiveTheSameBits) {
  const auto sights = scattered_sights(150, 3, {0.3, 0.4});
  const RigidMotion nothing;
  const MotionEstimate a = find_motion(sights, kTestEyes, nothing, {});
  const MotionEstimate b = find_motion(sights, kTestEyes, nothing, {});
  EXPECT_EQ(a.now_from_then.rotation, b.now_from_then.rotation);
  EXPECT_EQ(a.now_from_then.way_m, b.now_from_then.way_m);
  EXPECT_EQ(a.agrees, b.agrees);
}

/// Three cameras that see all points, moved off their places.
Bundle shaken_bundle() {
  Bundle bundle;
  bundle.eyes = kTestEyes;
  bundle.noise_px = 0.2;
  bundle.camera_from_world = {{}, kTestMotion, kTestMotion * kTestMotion};
  for (const MotionSight& sight : scattered_sights(40, 5, {})) {
    bundle.points_m.push_back(sight.point_m);
  }
  for (int p = 0; p < 40; ++p) {
    for (int c = 0; c < 3; ++c) {
      const cv::Vec3d seen = bundle.camera_from_world[static_cast<std::size_t>(c)] *
                             bundle.points_m[static_cast<std::size_t>(p)];
      bundle.sights.push_back({c, p, sight_of(kTestEyes, seen), 1.0});
    }
  }
  for (std::size_t c = 1; c < 3; ++c) {
    bundle.camera_from_world[c] =
        nudged(bundle.camera_from_world[c], {0.02, -0.01, 0.03, 0.004, -0.003, 0.002});
  }
  for (std::size_t p = 0; p < 40; ++p) {
    bundle.points_m[p] *= 1.0 + 0.02 * (static_cast<double>(p % 5) - 2.0);
  }
  return bundle;
}

TEST(Bundle, CamerasAndPointsReturnToWhereWhatWasSeenFits) {
  Bundle bundle = shaken_bundle();
  const double before = bundle_cost(bundle);
  for (int step = 0; step < 10; ++step) {
    Bundle moved;
    ASSERT_TRUE(bundle_step(bundle, 1e-6, moved));
    bundle = moved;
  }
  EXPECT_LT(bundle_cost(bundle), 1e-9 * before);
  EXPECT_LT(cv::norm(step_between(bundle.camera_from_world[1], kTestMotion)), 1e-6);
  EXPECT_LT(cv::norm(step_between(bundle.camera_from_world[2], kTestMotion * kTestMotion)), 1e-6);
}

}  // namespace
}  // namespace striate::perception
