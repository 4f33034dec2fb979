#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/core.hpp>

#include "tests/scenarios/ros/through_ros.hpp"
#include "tests/unit/ros/written_bag.hpp"

/// A bag as a body, end to end; no ROS master.
namespace striate::scenarios {
namespace {

/// Noise on a wall 1.2 m away, seen by both eyes.
void paint_wall(int /*pair*/, StereoFrame& frame) {
  constexpr int kDisparity_px = 20;
  cv::RNG random(7);
  cv::Mat3b wide(frame.left.rows, frame.left.cols + kDisparity_px);
  random.fill(wide, cv::RNG::UNIFORM, 0, 256);
  wide.colRange(0, frame.left.cols).copyTo(frame.left);
  wide.colRange(kDisparity_px, wide.cols).copyTo(frame.right);
}

std::vector<std::string> lines_of(const std::string& file) {
  std::vector<std::string> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

int replay(const reference::TemporaryFolder& folder, std::vector<std::string> words) {
  setenv("ROS_MASTER_URI", "http://127.0.0.1:1", 1);
  words.insert(words.begin(), {STRIATE_BINARY, "ros", "replay"});
  return Program(words, folder / "log").wait(60s);
}

TEST(RosReplay, LooksAtEachPairOfABagWithoutAMaster) {
  const reference::TemporaryFolder folder;
  ros::WrittenBag bag;
  bag.pairs = 12;
  bag.paint = paint_wall;
  ros::write_bag(folder / "wall.bag", bag);
  ASSERT_EQ(replay(folder, {folder / "wall.bag", "--out", folder / "out", "--picture-every", "6"}),
            0)
      << text_of(folder / "log");
  EXPECT_THAT(text_of(folder / "log"), testing::HasSubstr("12 image pairs"));
  const std::vector<std::string> lines = lines_of(folder / "out/percepts.jsonl");
  ASSERT_EQ(lines.size(), 12u);
  EXPECT_THAT(lines.back(), testing::HasSubstr("\"x_m\":0.33"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/overview_00006.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/overview_00012.png"));

  // The same bag, the same percepts.
  ASSERT_EQ(replay(folder, {folder / "wall.bag", "--out", folder / "again"}), 0);
  EXPECT_EQ(lines_of(folder / "again/percepts.jsonl"), lines);

  const std::string key = "\"disparity_known\":";
  const std::size_t at = lines.back().find(key);
  ASSERT_NE(at, std::string::npos);
  EXPECT_GT(std::stod(lines.back().substr(at + key.size())), 0.5);
}

TEST(RosReplay, AFileThatIsNoBagIsAMistakeOfTheUser) {
  const reference::TemporaryFolder folder;
  EXPECT_EQ(replay(folder, {folder.write("a.bag", "hello")}), 2);
  EXPECT_THAT(text_of(folder / "log"), testing::HasSubstr("no ROS bag"));
}

}  // namespace
}  // namespace striate::scenarios
