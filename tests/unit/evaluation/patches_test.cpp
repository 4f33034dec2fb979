#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/learning/learn_descriptor.hpp"
#include "striate/evaluation/learning/synthetic_images.hpp"
#include "striate/evaluation/patch_layouts.hpp"
#include "striate/evaluation/patch_methods.hpp"
#include "striate/perception/descriptor/striate_table.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

class PatchFolder : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  [[nodiscard]] std::string error() const {
    try {
      (void)load_patches(folder_.string(), {});
    } catch (const UserError& diagnostic) {
      return diagnostic.what();
    }
    return "none";
  }
  void write_mosaic() const {
    cv::imwrite((folder_ / "patches0000.bmp").string(), cv::Mat1b(1024, 1024, std::uint8_t{9}));
  }
  fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("patches_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(PatchFolder, OfTheOxfordLayoutGivesTrueAndFalsePairs) {
  fs::create_directories(folder_ / "made");
  const cv::Mat1b image = synthetic_image({320, 240}, 5);
  cv::imwrite((folder_ / "made/img1.png").string(), image);
  cv::imwrite((folder_ / "made/img2.png").string(), image);
  write("made/H1to2p", "1 0 0\n0 1 0\n0 0 1\n");
  PatchChoice choice;
  choice.pairs = 20;
  const PatchSet set = load_patches(folder_.string(), choice);
  ASSERT_EQ(set.count, 40);
  for (const PatchPair& pair : set.pairs) {
    const double difference = cv::norm(set.patch(pair.first), set.patch(pair.second), cv::NORM_L1);
    EXPECT_EQ(difference == 0.0, pair.same);
  }
  EXPECT_EQ(std::ranges::count(set.pairs, true, &PatchPair::same), 20);
}

TEST_F(PatchFolder, OfTheHPatchesLayoutGivesPatchesOfTheSamePlaces) {
  fs::create_directories(folder_ / "i_made");
  cv::Mat3b wide;  // PPM is a format of colours
  cv::cvtColor(synthetic_image({360, 240}, 6), wide, cv::COLOR_GRAY2BGR);
  cv::imwrite((folder_ / "i_made/1.ppm").string(), wide(cv::Rect(0, 0, 330, 240)));
  cv::imwrite((folder_ / "i_made/2.ppm").string(), wide(cv::Rect(30, 0, 330, 240)));
  write("i_made/H_1_2", "1 0 -30\n0 1 0\n0 0 1\n");
  PatchChoice choice;
  choice.pairs = 15;
  const PatchSet set = load_patches(folder_.string(), choice);
  ASSERT_EQ(std::ranges::count(set.pairs, true, &PatchPair::same), 15);
  double same = 0.0, other = 0.0;
  for (const PatchPair& pair : set.pairs) {
    const double difference = cv::norm(set.patch(pair.first), set.patch(pair.second), cv::NORM_L1);
    (pair.same ? same : other) += difference / 15.0 / (64.0 * 64.0);
  }
  EXPECT_LT(same, 4.0) << "grey levels: frames of SIFT are not exact near the border";
  EXPECT_GT(other, 4.0 * same);
}

TEST_F(PatchFolder, OfTheHPatchesLayoutTellsWhatIsMissing) {
  fs::create_directories(folder_ / "v_made");
  write("v_made/H_1_2", "1 0 0\n0 1 0\n0 0 1\n");
  EXPECT_THAT(error(), testing::HasSubstr("its images 1 and 2 are missing"));
  cv::imwrite((folder_ / "v_made/1.ppm").string(), cv::Mat3b(60, 60, cv::Vec3b(5, 5, 5)));
  cv::imwrite((folder_ / "v_made/2.ppm").string(), cv::Mat3b(60, 60, cv::Vec3b(5, 5, 5)));
  EXPECT_THAT(error(), testing::HasSubstr("no SIFT frame was found again"));
  write("v_made/H_1_2", "1 0 0\n0 1\n");
  EXPECT_THAT(error(), testing::HasSubstr("nine numbers"));
}

TEST_F(PatchFolder, OfTheBrownLayoutIsRead) {
  write("info.txt", "0 0\n0 0\n1 0\n");
  write("m50_2_2_0.txt", "0 0 0 1 0 0 0\n0 0 0 2 1 0 0\n");
  write_mosaic();
  const PatchSet set = load_patches(folder_.string(), {});
  ASSERT_EQ(set.pairs.size(), 2U);
  EXPECT_TRUE(set.pairs[0].same);
  EXPECT_FALSE(set.pairs[1].same);
  EXPECT_EQ(set.patch(2)(0, 0), 9);
}

TEST_F(PatchFolder, TellsFileAndLineOfADamagedMatch) {
  write("info.txt", "0 0\n1 0\n");
  write_mosaic();
  write("m50_2_2_0.txt", "0 0 0 1 1 0 0\n0 0 0 7 1 0 0\n");
  EXPECT_THAT(error(), testing::HasSubstr("m50_2_2_0.txt:2: expected patches 0 to 1"));
}

TEST_F(PatchFolder, WithoutDataTellsTheExpectedLayouts) {
  EXPECT_THAT(error(), testing::HasSubstr("H1to2p"));
  write("H1to2p", "1 0 0 0 1");
  EXPECT_THAT(error(), testing::HasSubstr("images img1 and img2 are missing"));
}

TEST(FalsePositiveRate, CountsFalsePairsNearerThanTheRecallNeeds) {
  std::vector<PatchPair> pairs;
  std::vector<float> distances;
  for (int k = 0; k < 20; ++k) {
    pairs.push_back({0, 1, true});
    distances.push_back(static_cast<float>(k));
    pairs.push_back({0, 1, false});
    distances.push_back(static_cast<float>(k) + 10.5F);
  }
  EXPECT_DOUBLE_EQ(false_positive_rate(pairs, distances, 0.95), 8.0 / 20.0);
  EXPECT_DOUBLE_EQ(false_positive_rate(pairs, distances, 0.5), 0.0);
}

TEST(LearnDescriptor, GivesTheSameReadableTableForTheSameSeed) {
  LearnOptions options;
  options.pictures = 2;
  options.seed = 3;
  const std::string table = learn_descriptor(options);
  EXPECT_EQ(learn_descriptor(options), table);
  EXPECT_NO_THROW((void)perception::parse_striate_table(table, "learned"));
}

}  // namespace
}  // namespace striate::evaluation
