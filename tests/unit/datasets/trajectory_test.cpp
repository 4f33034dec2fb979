#include "striate/platform/datasets/trajectories/trajectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "striate/base/user_error.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::datasets {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr const char* kTum =
    "# ground truth trajectory\n# timestamp tx ty tz qx qy qz qw\n"
    "1305031098.6659 1.3563 0.6305 1.6380 0.6132 0.5962 -0.3311 -0.3986\n"
    "1305031098.6758 1.3543 0.6306 1.6360 0.6129 0.5966 -0.3316 -0.3980\n";

TEST(ReadTrajectory, ReadsTumEuRocAndKittiByTheirContent) {
  const Trajectory tum = read_trajectory_text(kTum, "t");
  EXPECT_EQ(tum.format, "TUM");
  ASSERT_EQ(tum.poses.size(), 2U);
  EXPECT_EQ(tum.poses[0].stamp_ns, 1305031098665900000);
  EXPECT_EQ(tum.poses[1].position_m[1], 0.6306);
  const Trajectory euroc = read_trajectory_text(
      "#timestamp, p_RS_R_x [m], ...\n"
      "1403636580838555648,4.688319,-1.786938,0.783338,0.534108,-0.153029,-0.827383,-0.082152,"
      "-0.027876,0.033207,0.800006,-0.003172,0.021267,0.078502,-0.025266,0.136696,0.075593\n",
      "e");
  EXPECT_EQ(euroc.format, "EuRoC");
  EXPECT_EQ(euroc.poses[0].stamp_ns, 1403636580838555648);
  EXPECT_NEAR(quaternion_of(euroc.poses[0].rotation)[3], 0.534108, 1e-5);
  EXPECT_NEAR(quaternion_of(euroc.poses[0].rotation)[1], -0.827383, 1e-5);
  const Trajectory kitti = read_trajectory_text("1 0 0 1 0 1 0 2 0 0 1 3\n", "k", "0.5\n0.6\n");
  EXPECT_EQ(kitti.format, "KITTI");
  EXPECT_EQ(kitti.poses[0].stamp_ns, 500'000'000);
  EXPECT_EQ(kitti.poses[0].position_m[2], 3.0);
  EXPECT_TRUE(kitti.timed);
  EXPECT_FALSE(read_trajectory_text("1 0 0 1 0 1 0 2 0 0 1 3\n", "k").timed);
}

TEST(ReadTrajectory, OtherLineEndsMarksCommasAndAMissingLastLineEndChangeNothing) {
  std::string windows = "\xEF\xBB\xBF";
  for (const char* c = kTum; *c != '\0'; ++c) windows += *c == '\n' ? "\r\n" : std::string(1, *c);
  windows.resize(windows.size() - 2);
  std::string commas = kTum;
  for (char& c : commas) c = c == ' ' ? ',' : c;
  for (const std::string& text : {windows, commas, "\n\n" + std::string(kTum) + "\n  \n"}) {
    const Trajectory read = read_trajectory_text(text, "t");
    ASSERT_EQ(read.poses.size(), 2U) << text;
    EXPECT_EQ(read.poses[1].stamp_ns, 1305031098675800000);
    EXPECT_TRUE(read.remarks.empty());
  }
}

TEST(ReadTrajectory, LinesThatAreNoPoseAreLeftOutAndSaidAndTimesStandOnce) {
  const Trajectory read = read_trajectory_text(
      "3 1 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n2 nan 0 0 0 0 0 1\n2 9 0 0 0 0 0\n4 0 0 0 0 0 0 0\n"
      "1 5 0 0 0 0 0 1\n",
      "t");
  ASSERT_EQ(read.poses.size(), 2U);
  EXPECT_EQ(read.poses[0].position_m[0], 0.0);
  EXPECT_EQ(read.poses[1].position_m[0], 1.0);
  EXPECT_THAT(read.remarks, Contains(HasSubstr("3 lines are no pose: left out; the first: t:3:3: "
                                               "'nan' is no number")));
  EXPECT_THAT(read.remarks, Contains(HasSubstr("times go back")));
  EXPECT_THAT(read.remarks, Contains(HasSubstr("1 pose with the time of another")));
}

TEST(ReadTrajectory, ALineOfKittiThatIsNoPoseKeepsItsTime) {
  const Trajectory read = read_trajectory_text(
      "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 nan 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n", "k",
      "0\n0.1\n0.2\n");
  ASSERT_EQ(read.poses.size(), 2U);
  EXPECT_EQ(read.poses[1].stamp_ns, 200'000'000);
}

TEST(ReadTrajectory, SaysWhereAFileIsNone) {
  const auto mistake = [](const std::string& text, const std::string& times = "") -> std::string {
    try {
      (void)read_trajectory_text(text, "t", times);
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(mistake(""), HasSubstr("t: holds no trajectory"));
  EXPECT_THAT(mistake("hello\nworld\n"), HasSubstr("holds no trajectory"));
  EXPECT_THAT(mistake("1 2 3 4 5 6 7 8\n"), HasSubstr("t:1:9: the quaternion has length"));
  EXPECT_THAT(mistake("2 0 0 0 0 1 0 0 0 0 1 0\n"), HasSubstr("no rotation"));
  EXPECT_THAT(mistake("1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 0\n", "0.1\n"),
              HasSubstr("t: has 1 time for 2 poses"));
  EXPECT_THAT(mistake("1 0 0 0 0 1 0 0 0 0 1 0\n", "noon\n"), HasSubstr("times:1:1: 'noon'"));
}

TEST(ReadTrajectory, WhatIsWrittenForTumReadsBack) {
  const Trajectory read = read_trajectory_text(kTum, "t");
  const Trajectory again = read_trajectory_text(tum_text(read.poses), "t");
  ASSERT_EQ(again.poses.size(), read.poses.size());
  for (std::size_t k = 0; k < read.poses.size(); ++k) {
    EXPECT_EQ(again.poses[k].stamp_ns, read.poses[k].stamp_ns);
    EXPECT_LT(cv::norm(again.poses[k].rotation - read.poses[k].rotation), 1e-8);
  }
}

TEST(FindGroundTruth, LooksWhereEachSetKeepsIt) {
  const reference::TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::filesystem::create_directories(std::filesystem::path(folder / name).parent_path());
    (void)folder.write(name, text);
  };
  write("kitti/poses/07.txt", "1 0 0 1 0 1 0 2 0 0 1 3\n");
  write("kitti/sequences/07/times.txt", "0.25\n");
  write("tum/groundtruth.txt", kTum);
  write("euroc/mav0/state_groundtruth_estimate0/data.csv", "1403636580838555648,1,2,3,1,0,0,0\n");
  EXPECT_EQ(find_ground_truth(folder / "kitti/sequences/07").poses[0].stamp_ns, 250'000'000);
  EXPECT_EQ(find_ground_truth(folder / "kitti/poses/07.txt").poses[0].stamp_ns, 250'000'000);
  EXPECT_FALSE(find_ground_truth(folder / "kitti/sequences/07", KittiTimes::left_out).timed);
  EXPECT_FALSE(find_ground_truth(folder / "kitti/poses/07.txt", KittiTimes::left_out).timed);
  EXPECT_TRUE(find_ground_truth(folder / "tum", KittiTimes::left_out).timed);
  EXPECT_EQ(find_ground_truth(folder / "tum").format, "TUM");
  EXPECT_EQ(find_ground_truth(folder / "euroc").format, "EuRoC");
  EXPECT_THROW((void)find_ground_truth(folder.path()), UserError);
}

}  // namespace
}  // namespace striate::datasets
