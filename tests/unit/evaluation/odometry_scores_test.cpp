#include "striate/evaluation/odometry/odometry_scores.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/odometry/eval_odometry.hpp"

namespace striate::evaluation {
namespace {

using datasets::TimedPose;
using datasets::Trajectory;

cv::Matx33d turned_about_z(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c, -s, 0, s, c, 0, 0, 0, 1};
}

/// Through a hilly S, ten poses a second.
Trajectory a_drive(int poses) {
  Trajectory drive;
  for (int k = 0; k < poses; ++k) {
    const double t_s = 0.1 * k;
    TimedPose pose;
    pose.stamp_ns = k * 100'000'000LL;
    pose.position_m = {2.0 * t_s, 3.0 * std::sin(0.3 * t_s), 0.5 * std::sin(0.7 * t_s)};
    pose.rotation = turned_about_z(0.4 * std::sin(0.3 * t_s));
    drive.poses.push_back(pose);
  }
  return drive;
}

Trajectory moved(const Trajectory& drive, const cv::Vec3d& turn, const cv::Vec3d& way,
                 double scale = 1.0) {
  cv::Matx33d r;
  cv::Rodrigues(turn, r);
  Trajectory result = drive;
  for (TimedPose& pose : result.poses) {
    pose.position_m = scale * (r * pose.position_m) + way;
    pose.rotation = r * pose.rotation;
  }
  return result;
}

TEST(OdometryScores, ARigidMotionOfTheWholeCostsNothing) {
  const Trajectory truth = a_drive(300);
  const OdometryScores scores =
      score_odometry(truth, moved(truth, {0.3, -0.8, 1.9}, {5, -7, 11}), {});
  EXPECT_LT(scores.absolute.most, 1e-9);
  EXPECT_LT(scores.relative.way_m.most, 1e-9);
  EXPECT_LT(scores.relative.turn_deg.most, 1e-5);
  EXPECT_LT(scores.kitti.percent, 1e-9);
}

TEST(OdometryScores, AScaleIsFoundWhenAskedForAndElseCostsWhatItIs) {
  const Trajectory truth = a_drive(300);
  const Trajectory half = moved(truth, {0, 0, 1}, {1, 2, 3}, 0.5);
  OdometryOptions options;
  const double percent = score_odometry(truth, half, options).kitti.percent;
  EXPECT_LT(percent, 50.0);  // half of each stretch, which a bend makes a little shorter
  EXPECT_GT(percent, 47.0);
  options.scale = true;
  const OdometryScores scores = score_odometry(truth, half, options);
  EXPECT_NEAR(scores.alignment.scale, 2.0, 1e-9);
  EXPECT_LT(scores.absolute.most, 1e-9);
  EXPECT_LT(scores.kitti.percent, 1e-6);
}

TEST(OdometryScores, CountAsByHandOnASquare) {
  // Four corners, the estimate 0.1 m wider on either side: after alignment each is sqrt(2)/10 off.
  Trajectory truth;
  Trajectory estimate;
  const cv::Vec3d corners[] = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  for (int k = 0; k < 4; ++k) {
    truth.poses.push_back({k * 1'000'000'000LL, cv::Matx33d::eye(), corners[k]});
    estimate.poses.push_back({k * 1'000'000'000LL, cv::Matx33d::eye(), 1.1 * corners[k]});
  }
  const OdometryScores scores = score_odometry(truth, estimate, {});
  EXPECT_NEAR(scores.absolute.rmse, 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(scores.absolute.median, 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(scores.relative.way_m.count, 3U);
  EXPECT_NEAR(scores.relative.way_m.rmse, 0.2, 1e-12);
  EXPECT_NEAR(scores.way_m, 6.0, 1e-12);
}

TEST(OdometryScores, ASteadyDriftIsItsShareOfTheWayAndItsTurnByTheMetre) {
  // Straight on at 1 m a pose; the estimate goes 2 % too far and turns 0.01 degrees a metre.
  Trajectory truth;
  Trajectory estimate;
  TimedPose at;
  for (int k = 0; k < 500; ++k) {
    truth.poses.push_back({k * 100'000'000LL, cv::Matx33d::eye(), {1.0 * k, 0, 0}});
    at.stamp_ns = k * 100'000'000LL;
    estimate.poses.push_back(at);
    at.position_m += 1.02 * (at.rotation * cv::Vec3d(1, 0, 0));
    at.rotation = at.rotation * turned_about_z(1e-2 * CV_PI / 180.0);
  }
  const OdometryScores scores = score_odometry(truth, estimate, {});
  ASSERT_EQ(scores.kitti.lengths.size(), 4U);  // 100 to 400 m of 499
  EXPECT_EQ(scores.kitti.lengths[0].length_m, 100.0);
  // The first pose farther than 100 m lies at 101 m, as in the development kit.
  EXPECT_NEAR(scores.kitti.lengths[0].deg_per_m, 0.0101, 1e-6);
  EXPECT_NEAR(scores.kitti.lengths[0].percent,
              std::hypot(2.02, 101 * 1.02 * 0.01 * 101 * CV_PI / 360), 0.02);
  EXPECT_EQ(scores.kitti.lengths[0].count, 40U);  // every tenth pose up to 398
}

TEST(OdometryScores, TimesThatDifferAreInterpolatedAndGapsAreSaid) {
  Trajectory truth = a_drive(200);
  Trajectory estimate = truth;
  for (TimedPose& pose : estimate.poses) pose.stamp_ns += 50'000'000;  // half a step late
  estimate.poses.pop_back();
  for (std::size_t k = 0; k + 1 < truth.poses.size(); ++k) {
    estimate.poses[k].position_m =
        0.5 * (truth.poses[k].position_m + truth.poses[k + 1].position_m);
  }
  EXPECT_LT(score_odometry(truth, estimate, {}).absolute.most, 1e-9);
  truth.poses.erase(truth.poses.begin() + 50, truth.poses.begin() + 60);
  truth.poses.erase(truth.poses.begin(), truth.poses.begin() + 5);
  const OdometryScores scores = score_odometry(truth, estimate, {});
  EXPECT_EQ(scores.poses.outside, 5U);
  EXPECT_EQ(scores.poses.in_gaps, 11U);
  EXPECT_THAT(scores.poses.remarks, testing::Contains(testing::HasSubstr("in gaps of the truth")));
  EXPECT_LT(scores.absolute.most, 1e-9);
}

TEST(OdometryScores, WithoutTimesPosesArePairedByTheirLineAndElseTimesMustOverlap) {
  Trajectory truth = a_drive(50);
  for (std::size_t k = 0; k < 50; ++k)
    truth.poses[k].stamp_ns = static_cast<std::int64_t>(k) * 1'000'000'000;
  truth.timed = false;
  Trajectory estimate = truth;
  estimate.poses.erase(estimate.poses.begin() + 7);
  const OdometryScores scores = score_odometry(truth, estimate, {});
  EXPECT_EQ(scores.poses.pairs.size(), 49U);
  EXPECT_LT(scores.absolute.most, 1e-9);
  estimate.timed = true;
  EXPECT_THROW((void)score_odometry(truth, estimate, {}), UserError);
  truth.timed = true;
  for (TimedPose& pose : estimate.poses) pose.stamp_ns += 1'000'000'000'000;
  EXPECT_THROW((void)score_odometry(truth, estimate, {}), UserError);
  OdometryOptions options;
  options.pairing.offset_s = -1000.0;
  EXPECT_LT(score_odometry(truth, estimate, options).absolute.most, 1e-9);
}

TEST(OdometryScores, HalfATurnAndALineAreNoTrouble) {
  Trajectory truth;
  Trajectory estimate;
  for (int k = 0; k < 20; ++k) {
    truth.poses.push_back({k * 1'000'000'000LL, cv::Matx33d::eye(), {0.5 * k, 0, 0}});
    estimate.poses.push_back({k * 1'000'000'000LL, turned_about_z(CV_PI), {-0.5 * k, 0, 0}});
  }
  const OdometryScores scores = score_odometry(truth, estimate, {});
  EXPECT_LT(scores.absolute.most, 1e-9);
  EXPECT_LT(scores.relative.turn_deg.most, 1e-6);
}

}  // namespace
}  // namespace striate::evaluation
