#include "striate/evaluation/odometry/compare_odometry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace striate::evaluation {
namespace {

using perception::NoEstimate;
using perception::VisualPose;
using testing::HasSubstr;

VisualPose pose_of(NoEstimate reason, double z_m) {
  VisualPose pose;
  pose.reason = reason;
  pose.world_from_camera.way_m = {0.0, 0.0, z_m};
  return pose;
}

/// Straight on, one metre a view, from `reasons`.
MethodRun run_of(const std::string& name, const std::vector<NoEstimate>& reasons, bool timed) {
  MethodRun run;
  run.name = name;
  for (std::size_t k = 0; k < reasons.size(); ++k) {
    std::optional<std::int64_t> stamp_ns;
    if (timed) stamp_ns = static_cast<std::int64_t>(k) * 100'000'000;
    take_pose(pose_of(reasons[k], 1.0 * static_cast<double>(k)), k, stamp_ns, cv::Matx33d::eye(),
              run);
  }
  take_means(run);
  return run;
}

datasets::Trajectory true_way(bool timed) {
  datasets::Trajectory truth;
  truth.format = "KITTI";
  truth.timed = timed;
  for (int k = 0; k < 6; ++k) {
    const std::int64_t step_ns = timed ? 100'000'000 : 1'000'000'000;
    truth.poses.push_back({k * step_ns, cv::Matx33d::eye(), {0.0, 0.0, 1.0 * k}});
  }
  return truth;
}

const std::vector<NoEstimate> kAllKnown = {NoEstimate::beginning, NoEstimate::none,
                                           NoEstimate::none, NoEstimate::none};
const std::vector<NoEstimate> kNoneKnown(4, NoEstimate::too_little_texture);

TEST(CompareOdometry, EachRunIsJudgedOrSaysWhyNot) {
  std::vector<MethodRun> runs = {run_of("dark", kNoneKnown, true), run_of("good", kAllKnown, true),
                                 run_of("short", {NoEstimate::beginning, NoEstimate::none}, true),
                                 run_of("untimed", kAllKnown, false)};
  score_runs(true_way(true), {}, runs);
  EXPECT_FALSE(runs[0].scores);
  EXPECT_THAT(runs[0].why_no_scores, HasSubstr("no view had an estimate"));
  ASSERT_TRUE(runs[1].scores);
  EXPECT_LT(runs[1].scores->absolute.rmse, 1e-9);
  EXPECT_EQ(runs[1].why_no_scores, "");
  EXPECT_THAT(runs[2].why_no_scores, HasSubstr("too few poses belong together: 2"));
  EXPECT_THAT(runs[3].why_no_scores, HasSubstr("the sequence has none"));
  EXPECT_THAT(runs[3].why_no_scores, testing::Not(HasSubstr("--times")));
}

TEST(CompareOdometry, WithoutTimesAViewIsPairedByItsNumber) {
  std::vector<MethodRun> runs = {run_of("counted", kAllKnown, false)};
  datasets::Trajectory truth = true_way(false);
  truth.poses.erase(truth.poses.begin() + 1);  // a line that was no pose
  score_runs(truth, {}, runs);
  ASSERT_TRUE(runs[0].scores) << runs[0].why_no_scores;
  EXPECT_EQ(runs[0].scores->poses.pairs.size(), 3U);
  EXPECT_LT(runs[0].scores->absolute.rmse, 1e-9);
}

TEST(CompareOdometry, TheShareWithoutAnEstimateIsOfAllViews) {
  std::vector<MethodRun> runs = {run_of("dark", kNoneKnown, true)};
  const auto json = nlohmann::json::parse(runs_json(runs, {}));
  EXPECT_EQ(json[0]["share_without"], 1.0);
  EXPECT_THAT(runs_text(runs, {}), HasSubstr("4 views, no ground truth"));
  score_runs(true_way(true), {}, runs);
  EXPECT_THAT(runs_text(runs, {}), HasSubstr("4 views, no run could be judged"));
  EXPECT_EQ(runs[0].known, 0U);
  EXPECT_EQ(runs[0].why["too_little_texture"], 4U);
}

TEST(CompareOdometry, TheEndIsComparedWhereBothBeginAsOne) {
  std::vector<MethodRun> runs = {run_of("good", kAllKnown, true)};
  for (datasets::TimedPose& pose : runs[0].estimate.poses) pose.position_m *= 1.1;
  score_runs(true_way(true), {}, runs);
  ASSERT_TRUE(runs[0].scores);
  EXPECT_NEAR(end_error_m(*runs[0].scores), 0.3, 1e-9);
  EXPECT_NEAR(estimated_way_m(runs[0]), 3.3, 1e-9);
}

}  // namespace
}  // namespace striate::evaluation
