#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/homography_sequence.hpp"
#include "striate/evaluation/repeatability.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("eval_keypoints_" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

/// Two images, the second one moved 7 px to the left.
void write_pair(const fs::path& folder, const std::string& image, const std::string& homography) {
  fs::create_directories(folder);
  const cv::Mat1b wide = reference::texture({227, 160}, 3);
  cv::imwrite((folder / (image + "1.png")).string(), wide(cv::Rect(0, 0, 220, 160)));
  cv::imwrite((folder / (image + "2.png")).string(), wide(cv::Rect(7, 0, 220, 160)));
  write_text(folder / homography, "1 0 -7\n0 1 0\n0 0 1\n");
}

const ImagePair kMoved{{100, 100}, {100, 100}, {1, 0, 10, 0, 1, 0, 0, 0, 1}};

TEST(Repeatability, CountsPlacesThatComeAgainInTheCommonPart) {
  // (95, 50) maps to 105, outside; (5, 50) of the second comes from -5, outside.
  const Repeatability result = repeatability({{20, 20}, {40, 40}, {95, 50}},
                                             {{31, 20}, {50, 44}, {5, 50}, {70, 70}}, kMoved, 1.5);
  EXPECT_EQ(result.common, 2);
  EXPECT_EQ(result.repeated, 1);
  EXPECT_DOUBLE_EQ(result.share(), 0.5);
}

TEST(Repeatability, UsesAKeypointOnceAndPairsTheNearestFirst) {
  const Repeatability result =
      repeatability({{20, 20}, {21, 20}}, {{30.6, 20}, {33.0, 20}}, kMoved, 2.5);
  EXPECT_EQ(result.repeated, 1) << "31 takes 30.6, the nearest; from 30 it is 3 px to 33";
  EXPECT_EQ(repeatability({{20, 20}, {21, 20}}, {{30.6, 20}}, kMoved, 2.5).repeated, 1);
}

TEST(Repeatability, OfNothingIsNothing) {
  EXPECT_EQ(repeatability({}, {{1, 1}}, kMoved, 2.5).share(), 0.0);
}

TEST(HomographySequence, ReadsOxfordAndHPatchesInTheFolderOrBelow) {
  const fs::path folder = fresh_folder("layouts");
  write_pair(folder / "b", "img", "H1to2p");
  write_pair(folder / "a", "", "H_1_2");
  fs::create_directories(folder / "other");
  const auto found = find_homography_sequences(folder);
  ASSERT_EQ(found.size(), 2U);
  for (const fs::path& path : found) {
    const HomographySequence sequence = read_homography_sequence(path);
    EXPECT_EQ(sequence.pictures.size(), 2U);
    ASSERT_EQ(sequence.to.size(), 1U);
    EXPECT_EQ(projected(sequence.to[0], {10, 3}), cv::Point2d(3, 3));
  }
  EXPECT_EQ(read_homography_sequence(found[0]).name, "a");
  EXPECT_EQ(find_homography_sequences(folder / "b").size(), 1U);
}

TEST(HomographySequence, SaysWhatIsExpectedOrCannotBeRead) {
  const fs::path folder = fresh_folder("wrong");
  EXPECT_THROW(find_homography_sequences(folder), UserError);
  EXPECT_THROW(find_homography_sequences(folder / "missing"), UserError);
  write_pair(folder, "img", "H1to2p");
  write_text(folder / "H1to2p", "1 0 0 0 nonsense");
  EXPECT_THROW(read_homography_sequence(folder), UserError);
  write_text(folder / "H1to2p", "1 0 0 0 1 0 0 0 1");
  write_text(folder / "img2.png", "no image");
  EXPECT_THROW(read_homography_sequence(folder), UserError);
}

TEST(EvalKeypoints, WritesTableAndPlot) {
  const fs::path folder = fresh_folder("run"), out = fresh_folder("out");
  write_pair(folder / "moved", "img", "H1to2p");
  EXPECT_EQ(evaluate_keypoints({folder.string(), out.string()}), 0);
  std::stringstream csv;
  csv << std::ifstream(out / "keypoints.csv").rdbuf();
  std::string line, found;
  while (std::getline(csv, line)) {
    if (line.starts_with("moved,2,Striate K_D,500,1.5,")) found = line;
  }
  ASSERT_FALSE(found.empty());
  EXPECT_GT(std::stod(found.substr(found.rfind(',') + 1)), 0.9) << "a move by whole pixels";
  EXPECT_TRUE(fs::is_regular_file(out / "keypoints.svg"));
}

TEST(EvalKeypoints, TakesTheHPatchesLayout) {
  const fs::path folder = fresh_folder("hpatches"), out = fresh_folder("hpatches_out");
  write_pair(folder / "v_moved", "", "H_1_2");
  EXPECT_EQ(evaluate_keypoints({folder.string(), out.string()}), 0);
  std::stringstream csv;
  csv << std::ifstream(out / "keypoints.csv").rdbuf();
  EXPECT_NE(csv.str().find("\nv_moved,2,Striate K_D,500,1.5,"), std::string::npos);
}

}  // namespace
}  // namespace striate::evaluation
