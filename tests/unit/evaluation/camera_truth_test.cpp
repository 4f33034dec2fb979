#include "striate/evaluation/odometry/camera_truth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "striate/evaluation/odometry/eval_odometry.hpp"
#include "striate/perception/visual_odometry/rigid_motion.hpp"

namespace striate::evaluation {
namespace {

using datasets::TimedPose;
using datasets::Trajectory;

/// A camera that drives round a bend on a plane, z forward, two metres a second; with `hills` it
/// nods and rolls as well.
Trajectory bend(double hills) {
  Trajectory way;
  cv::Vec3d at{};
  for (int k = 0; k < 120; ++k) {
    TimedPose pose;
    pose.stamp_ns = k * 100'000'000LL;
    pose.rotation = perception::rotation_about({0.0, 0.012 * k, 0.0}) *
                    perception::rotation_about({hills * std::sin(0.1 * k), 0.0, 0.0}) *
                    perception::rotation_about({0.0, 0.0, hills * std::sin(0.07 * k)});
    pose.position_m = at;
    at += pose.rotation * cv::Vec3d(0.0, 0.0, 0.2);
    way.poses.push_back(pose);
  }
  return way;
}

/// An estimate of it in a world of its own, whose turns and ways err a little.
Trajectory guessed(const Trajectory& truth, double scale = 1.0) {
  Trajectory guess = truth;
  const cv::Matx33d world = perception::rotation_about({0.3, -0.5, 0.2});
  for (std::size_t k = 0; k < guess.poses.size(); ++k) {
    const double drift = 1e-4 * static_cast<double>(k);
    TimedPose& pose = guess.poses[k];
    pose.rotation = world * perception::rotation_about({drift, -drift, drift}) * pose.rotation;
    pose.position_m = scale * (1.0 + drift) * (world * pose.position_m) + cv::Vec3d(1, 2, 3);
  }
  return guess;
}

Trajectory inverted(Trajectory truth) {
  for (TimedPose& pose : truth.poses) pose.rotation = pose.rotation.t();
  return truth;
}

/// The same truth for a sensor that sits elsewhere on the body.
Trajectory of_the_sensor(Trajectory truth, const cv::Matx44d& body_from_sensor) {
  std::vector<PosePair> pairs;
  for (const TimedPose& pose : truth.poses) pairs.push_back({pose, pose});
  move_to_sensor(body_from_sensor, pairs);
  for (std::size_t k = 0; k < pairs.size(); ++k) truth.poses[k] = pairs[k].truth;
  return truth;
}

bool was_inverted(const OdometryScores& scores) {
  return testing::Value(scores.poses.remarks,
                        testing::Contains(testing::HasSubstr("and inverted")));
}

TEST(TruthOfACamera, RotationsThatAreInvertedAreFoundInAnyScoreAndSaid) {
  for (const double hills : {0.0, 0.1}) {
    for (const double scale : {1.0, 0.3}) {
      const Trajectory truth = bend(hills);
      const Trajectory guess = guessed(truth, scale);
      OdometryOptions options;
      options.scale = scale != 1.0;
      const OdometryScores right = score_odometry(truth, guess, options);
      EXPECT_FALSE(was_inverted(right)) << hills << " " << scale;
      const OdometryScores mended = score_odometry(inverted(truth), guess, options);
      EXPECT_TRUE(was_inverted(mended)) << hills << " " << scale;
      EXPECT_NEAR(mended.kitti.percent, right.kitti.percent, 1e-6);
      EXPECT_NEAR(mended.relative.turn_deg.rmse, right.relative.turn_deg.rmse, 1e-6);
    }
  }
}

TEST(TruthOfACamera, ARightTruthInOtherAxesIsNotTakenForAnInvertedOne) {
  // On a plane the turns of OpenGL's axes (y up, z back) are exactly the inverse ones.
  const Trajectory truth = bend(0.0);
  Trajectory other = truth;
  for (TimedPose& pose : other.poses) {
    pose.rotation = pose.rotation * cv::Matx33d(1, 0, 0, 0, -1, 0, 0, 0, -1);
  }
  EXPECT_FALSE(was_inverted(score_odometry(other, guessed(truth), {})));
}

TEST(TruthOfACamera, ABodysTruthIsTurnedRoundBeforeItIsMovedToTheSensor) {
  const cv::Matx33d turn = perception::rotation_about({-1.2, 0.9, -1.1});
  const cv::Matx44d body_from_sensor(turn(0, 0), turn(0, 1), turn(0, 2), 0.4,   //
                                     turn(1, 0), turn(1, 1), turn(1, 2), -0.3,  //
                                     turn(2, 0), turn(2, 1), turn(2, 2), 0.2,   //
                                     0, 0, 0, 1);
  const Trajectory body = bend(0.1);
  const Trajectory guess = guessed(of_the_sensor(body, body_from_sensor));
  OdometryOptions options;
  options.body_from_sensor = body_from_sensor;
  const OdometryScores right = score_odometry(body, guess, options);
  EXPECT_FALSE(was_inverted(right));
  EXPECT_LT(right.absolute.rmse, 0.1);
  const OdometryScores mended = score_odometry(inverted(body), guess, options);
  EXPECT_TRUE(was_inverted(mended));
  EXPECT_NEAR(mended.absolute.rmse, right.absolute.rmse, 1e-9);
  EXPECT_NEAR(mended.kitti.percent, right.kitti.percent, 1e-6);
}

TEST(TruthOfACamera, AWayWithoutTurnsOrOfTwoPosesTellsNothing) {
  Trajectory straight = bend(0.0);
  for (TimedPose& pose : straight.poses) pose.rotation = cv::Matx33d::eye();
  EXPECT_FALSE(was_inverted(score_odometry(straight, guessed(straight), {})));
  EXPECT_FALSE(rotations_are_inverted({}, {}, false));
  EXPECT_FALSE(rotations_are_inverted({{straight.poses[0], straight.poses[0]}}, {}, true));
}

}  // namespace
}  // namespace striate::evaluation
