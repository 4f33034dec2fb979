#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "striate/base/files.hpp"
#include "striate/platform/datasets/trajectories/trajectory.hpp"
#include "tests/reference/rendered_sequence.hpp"
#include "tests/scenarios/striate_process.hpp"

/// What `striate eval odometry` makes of a truth: of a sequence, and of a trajectory.
namespace striate::scenarios {
namespace {

using reference::write_rendered_sequence;
using testing::HasSubstr;
using testing::Not;

int times_in(const std::string& text, const std::string& words) {
  int count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
    ++count;
  }
  return count;
}

/// KITTI's lines of a bend: 0.1 m a pose, `at` of a line that is no pose; -1: none
std::string kitti_way(int poses, int at = -1) {
  std::string text;
  for (int k = 0; k < poses; ++k) {
    const double angle_rad = 0.05 * k;
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    text += fmt::format("{} 0 {} {} 0 1 0 {} {} 0 {} {}\n", c, s, k == at ? "nan" : "0",
                        0.2 * (k % 3), -s, c, 0.1 * k);
  }
  return text;
}

TEST(JudgedOdometry, ATruthThatCannotBeReadIsSaidBeforeTheRun) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 2);
  std::filesystem::remove(sequence + "/calib.txt");  // the run would end with this
  const Ended ended = striate(
      {"eval", "odometry", sequence, "--truth", folder / "nowhere.txt", "--out", folder / "out"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("nowhere.txt: there is no such file"));
}

TEST(JudgedOdometry, WhatWasSeenIsWrittenThoughTheTruthIsOfAnotherTime) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 4);
  const std::string truth =
      folder.write("late.tum", "1000 0 0 0 0 0 0 1\n1001 0 0 1 0 0 0 1\n1002 0 0 2 0 0 0 1\n");
  const Ended ended =
      striate({"eval", "odometry", sequence, "--truth", truth, "--out", folder / "out"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("no run could be judged: too few poses belong together"));
  EXPECT_THAT(ended.out, HasSubstr("4 views, no run could be judged"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/methods.csv"));
  EXPECT_EQ(datasets::read_trajectory(folder / "out/Striate.tum").poses.size(), 4U);
}

TEST(JudgedOdometry, WithoutAnyEstimateTheExitCodeSaysSo) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 3, 0, 3);
  const Ended ended = striate({"eval", "odometry", sequence, "--json", "--out", folder / "out"});
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  for (const nlohmann::json& run : nlohmann::json::parse(ended.out))
    EXPECT_EQ(run["share_without"], 1.0);
}

TEST(JudgedOdometry, WhatIsAssumedOfCameraAndTruthIsSaidOnce) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 12);
  datasets::Trajectory truth = datasets::find_ground_truth(sequence);
  for (datasets::TimedPose& pose : truth.poses) pose.rotation = pose.rotation.t();
  const std::string file = folder.write("inverted.tum", datasets::tum_text(truth.poses));
  const Ended ended =
      striate({"eval", "odometry", sequence, "--truth", file, "--out", folder / "out"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(times_in(ended.err, "and inverted"), 1) << ended.err;
  EXPECT_EQ(times_in(ended.err, "calibration: KITTI"), 1) << ended.err;
  const Ended again = striate({"eval", "odometry", folder / "out/Striate.tum", "--truth", file,
                               "--json", "--out", folder / "again"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(times_in(again.err, "and inverted"), 1) << again.err;
  EXPECT_LT(nlohmann::json::parse(again.out)["rpe_deg"]["rmse"].get<double>(), 1.0);
  const Ended alone = striate({"odometry", sequence, "--to", "1"});
  EXPECT_EQ(times_in(alone.err, "calibration: KITTI"), 1) << alone.err;
}

TEST(JudgedOdometry, ALineThatIsNoPoseShiftsNothingWithTimesAndWithout) {
  const TemporaryFolder folder;
  const std::string estimate = folder.write("estimate.txt", kitti_way(20));
  std::filesystem::create_directories(folder / "truth");
  (void)folder.write("truth/poses.txt", kitti_way(20, 7));
  for (const bool times : {false, true}) {
    std::string text;
    for (int k = 0; k < 20; ++k) text += fmt::format("{}\n", 0.1 * k);
    if (times) (void)folder.write("truth/times.txt", text);
    const Ended ended = striate({"eval", "odometry", estimate, "--truth", folder / "truth",
                                 "--json", "--out", folder / "out"});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(nlohmann::json::parse(ended.out)["poses"], 19);
    EXPECT_LT(nlohmann::json::parse(ended.out)["ate_m"]["rmse"].get<double>(), 1e-9) << times;
  }
}

TEST(JudgedOdometry, PicturesWithoutTimesArePairedByTheirNumberWithPosesThatHaveSome) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 6);
  std::filesystem::create_directories(folder / "truth");
  std::filesystem::rename(sequence + "/times.txt", folder / "truth/times.txt");
  std::string poses = read_file(folder / "poses/00.txt");
  poses.replace(poses.find('\n') + 1, 1, "x");  // the second line is no pose
  (void)folder.write("truth/poses.txt", poses);
  (void)folder.write("truth/t.tum", "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n");
  const Ended ended = striate({"eval", "odometry", sequence, "--truth", folder / "truth/poses.txt",
                               "--json", "--out", folder / "out"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const nlohmann::json scores = nlohmann::json::parse(ended.out)[0]["scores"];
  EXPECT_EQ(scores["poses"], 5);
  EXPECT_LT(scores["ate_m"]["rmse"].get<double>(), 0.005);
  const Ended tum = striate(
      {"eval", "odometry", sequence, "--truth", folder / "truth/t.tum", "--out", folder / "out"});
  EXPECT_EQ(tum.exit_code, 2);
  EXPECT_THAT(tum.err, HasSubstr("the truth has times and the sequence has none"));
  EXPECT_THAT(tum.err, Not(HasSubstr("--times")));
}

TEST(JudgedOdometry, ATruthOfTheBodyIsMovedToTheCameraOfItsSet) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "mav0/state_groundtruth_estimate0");
  std::filesystem::create_directories(folder / "mav0/cam0");
  // The camera sits half a metre to the body's left and looks along the body's x.
  (void)folder.write("mav0/cam0/sensor.yaml",
                     "sensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n  data: [0.0, 0.0, 1.0, "
                     "0.0, -1.0, 0.0, 0.0, 0.5, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]\n");
  std::string body = "#timestamp,x,y,z,qw,qx,qy,qz\n";
  const cv::Matx33d body_from_camera(0, 0, 1, -1, 0, 0, 0, -1, 0);
  std::vector<datasets::TimedPose> seen;
  for (int k = 0; k < 20; ++k) {
    datasets::TimedPose pose;
    pose.stamp_ns = 1'400'000'000'000'000'000 + k * 100'000'000LL;
    const double half_rad = 0.05 * k;
    pose.rotation = datasets::rotation_of({0, 0, std::sin(half_rad), std::cos(half_rad)});
    pose.position_m = {0.2 * k, 0.1 * (k % 4), 0.0};
    body += fmt::format("{},{},{},0,{},0,0,{}\n", pose.stamp_ns, pose.position_m[0],
                        pose.position_m[1], std::cos(half_rad), std::sin(half_rad));
    pose.position_m += pose.rotation * cv::Vec3d(0.0, 0.5, 0.0);
    pose.rotation = pose.rotation * body_from_camera;
    seen.push_back(pose);
  }
  (void)folder.write("mav0/state_groundtruth_estimate0/data.csv", body);
  const std::string estimate = folder.write("camera.tum", datasets::tum_text(seen));
  const auto judged = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"eval",        "odometry", estimate, "--truth",
                                      folder.path(), "--json",   "--out",  folder / "out"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = striate(words);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return std::pair(nlohmann::json::parse(ended.out), ended.err);
  };
  const auto [moved, said] = judged({});
  EXPECT_LT(moved["ate_m"]["rmse"].get<double>(), 1e-6);
  EXPECT_LT(moved["rpe_deg"]["rmse"].get<double>(), 1e-3);
  EXPECT_THAT(said, HasSubstr("the truth is of the body"));
  EXPECT_THAT(said, Not(HasSubstr("and inverted")));
  EXPECT_GT(judged({"--sensor", "body"}).first["ate_m"]["rmse"].get<double>(), 0.01);
}

TEST(JudgedOdometry, OptionsThatSayNothingOfWhatIsJudgedAreRefused) {
  const TemporaryFolder folder;
  const std::string sequence = write_rendered_sequence(folder, 2);
  const Ended of_pictures = striate({"eval", "odometry", sequence, "--times", "nowhere"});
  EXPECT_EQ(of_pictures.exit_code, 2);
  EXPECT_THAT(of_pictures.err, HasSubstr("is a sequence of pictures, of which nothing is said by "
                                         "--times"));
  const std::string poses = folder / "poses/00.txt";
  const Ended of_poses = striate({"eval", "odometry", poses, "--truth", poses, "--swap",
                                  "--calibration", "nowhere", "--width-px", "320"});
  EXPECT_EQ(of_poses.exit_code, 2);
  for (const char* option : {"--swap", "--calibration", "--width-px"}) {
    EXPECT_THAT(of_poses.err, HasSubstr(option));
  }
  const Ended picture = striate({"eval", "odometry", sequence + "/image_0/000000.png"});
  EXPECT_EQ(picture.exit_code, 2);
  EXPECT_THAT(picture.err, HasSubstr("is one picture"));
  const Ended nothing = striate({"eval", "odometry", folder / "nowhere"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("there is no such file"));
}

}  // namespace
}  // namespace striate::scenarios
