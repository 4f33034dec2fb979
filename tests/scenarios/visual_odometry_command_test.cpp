#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "striate/platform/datasets/trajectories/trajectory.hpp"
#include "tests/reference/rendered_sequence.hpp"
#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {
namespace {

using reference::write_rendered_sequence;
using testing::HasSubstr;

TEST(OdometryCommand, WritesTheWayThatTheCameraWent) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 10);
  const Ended ended = striate({"odometry", sequence, "--out", folder / "way.tum"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("the beginning"));
  EXPECT_THAT(ended.out, HasSubstr("10 views, 9 with an estimate"));
  const datasets::Trajectory way = datasets::read_trajectory(folder / "way.tum");
  ASSERT_EQ(way.poses.size(), 10U);
  EXPECT_LT(cv::norm(way.poses.back().position_m - reference::sequence_pose(9).way_m), 0.01);
}

TEST(OdometryCommand, TellsWhereThereIsNoEstimateAndLeavesItOutOfTheTrajectory) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 8, 3, 2);
  const Ended ended = striate({"odometry", sequence, "--json", "--out", folder / "way.tum"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  std::vector<nlohmann::json> lines;
  std::istringstream text(ended.out);
  for (std::string line; std::getline(text, line);) lines.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_EQ(lines[0]["reason"], "beginning");
  EXPECT_TRUE(lines[0].contains("position_m"));
  EXPECT_FALSE(lines[0].contains("noise_px"));  // nothing was measured
  EXPECT_FALSE(lines[0].contains("from_keyframe_sigma_m"));
  EXPECT_EQ(lines[4]["reason"], "too_little_texture");
  EXPECT_FALSE(lines[4].contains("position_m"));
  EXPECT_EQ(lines[5]["reason"], "estimated");
  EXPECT_GT(lines[5]["from_keyframe_sigma_m"].get<double>(), 0.0);
  EXPECT_EQ(lines[8]["summary"]["known"], 5);
  EXPECT_EQ(datasets::read_trajectory(folder / "way.tum").poses.size(), 6U);
}

TEST(OdometryCommand, CountsOneAndTellsWhereThereIsNoEstimateAtAll) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 1);
  const Ended ended = striate({"odometry", sequence});
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  EXPECT_THAT(ended.out,
              HasSubstr("1 view, 0 with an estimate, 0.00 m of way, begun anew 0 times"));
}

TEST(OdometryCommand, WantsTwoEyesAndACalibrationAndSaysSo) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 3);
  std::filesystem::remove(sequence + "/calib.txt");
  const Ended without = striate({"odometry", sequence});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.err, HasSubstr("--calibration FILE"));
  const Ended one_eye = striate({"odometry", sequence + "/image_0"});
  EXPECT_EQ(one_eye.exit_code, 2);
  EXPECT_THAT(one_eye.err, HasSubstr("two eyes"));
  const Ended nothing = striate({"odometry", folder / "nowhere"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("nowhere"));
}

TEST(EvalOdometryOfASequence, ComparesWithOrbAndSiftInOneRun) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 12);
  const Ended ended = striate({"eval", "odometry", sequence, "--json", "--out", folder / "out"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const nlohmann::json runs = nlohmann::json::parse(ended.out);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0]["features"], "Striate");
  EXPECT_EQ(runs[1]["features"], "ORB");
  EXPECT_EQ(runs[2]["features"], "SIFT");
  EXPECT_EQ(runs[0]["without_estimate"], 0);
  EXPECT_LT(runs[0]["end_error_m"].get<double>(), 0.01);
  EXPECT_LT(runs[0]["scores"]["ate_m"]["rmse"].get<double>(), 0.01);
  for (const char* file : {"methods.csv", "errors.svg", "Striate.tum", "SIFT.tum",
                           "ORB/odometry.png", "Striate/odometry.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" + "/" + file)) << file;
  }
  const Ended again = striate({"eval", "odometry", folder / "out/Striate.tum", "--truth", sequence,
                               "--json", "--out", folder / "again"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NEAR(nlohmann::json::parse(again.out)["ate_m"]["rmse"].get<double>(),
              runs[0]["scores"]["ate_m"]["rmse"].get<double>(), 1e-6);
}

TEST(EvalOdometryOfASequence, DarkPicturesAreViewsWithoutAnEstimateOfEveryMethod) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 8, 3, 2);
  const Ended ended = striate({"eval", "odometry", sequence, "--json", "--out", folder / "out"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  for (const nlohmann::json& run : nlohmann::json::parse(ended.out)) {
    EXPECT_EQ(run["without_estimate"], 2) << run["features"];
    EXPECT_EQ(run["why"]["too_little_texture"], 2) << run["features"];
  }
}

TEST(EvalOdometryOfASequence, WithoutATruthTellsWhatCanBeTold) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 4);
  std::filesystem::remove(folder / "poses/00.txt");
  const Ended ended = striate({"eval", "odometry", sequence, "--out", folder / "out"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("no ground truth"));
  EXPECT_THAT(ended.out, HasSubstr("Striate"));
  const Ended file = striate({"eval", "odometry", folder / "out/Striate.tum"});
  EXPECT_EQ(file.exit_code, 2);
  EXPECT_THAT(file.err, HasSubstr("--truth FILE"));
}

}  // namespace
}  // namespace striate::scenarios
