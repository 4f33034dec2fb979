#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/fixations.hpp"
#include "striate/evaluation/saliency_scores.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

/// A blur of nearly nothing: the fixation map is the fixations themselves.
constexpr double kNoBlur_px = 0.05;

TEST(SaliencyScores, AreThoseComputedByHand) {
  // One row: the fixations are on the values 4 and 2, the other values are 3, 1, 0.
  const cv::Mat1f map = (cv::Mat1f(1, 5) << 4, 3, 2, 1, 0);
  const SaliencyScores s = score_salience(map, {{0, 0}, {2, 0}}, kNoBlur_px);
  // The curve goes (0, 0), (0, 1/2) at 4, (1/3, 1) at 2, (1, 1): 1/3 (1/2 + 1)/2 + 2/3.
  EXPECT_NEAR(s.auc_judd, 0.25 + 2.0 / 3.0, 1e-6);
  // Mean 2, deviation sqrt(2): (2 + 0) / sqrt(2) / 2.
  EXPECT_NEAR(s.nss, 1.0 / std::sqrt(2.0), 1e-6);
  // Against 1 0 1 0 0, mean 0.4, deviation sqrt(0.24): the products' mean is (4 + 2) / 5 - 2 * 0.4.
  EXPECT_NEAR(s.cc, 0.4 / std::sqrt(2.0 * 0.24), 1e-5);
}

TEST(SaliencyScores, APerfectMapAndItsOpposite) {
  cv::Mat1f map(20, 30, 0.0F);
  map(5, 7) = map(12, 20) = 1.0F;
  const std::vector<cv::Point> fixations = {{7, 5}, {20, 12}};
  EXPECT_NEAR(score_salience(map, fixations, kNoBlur_px).auc_judd, 1.0, 1e-9);
  EXPECT_NEAR(score_salience(map, fixations, kNoBlur_px).cc, 1.0, 1e-5);
  EXPECT_NEAR(score_salience(1.0F - map, fixations, kNoBlur_px).cc, -1.0, 1e-5);
}

TEST(SaliencyScores, TiesCountHalfAndAFlatMapIsChance) {
  const cv::Mat1f ties = (cv::Mat1f(1, 4) << 1, 1, 0, 0);
  EXPECT_NEAR(score_salience(ties, {{0, 0}, {2, 0}}, kNoBlur_px).auc_judd, 0.5, 1e-9);
  const SaliencyScores flat = score_salience(cv::Mat1f(4, 4, 3.0F), {{1, 1}}, 1.0);
  EXPECT_DOUBLE_EQ(flat.auc_judd, 0.5);
  EXPECT_DOUBLE_EQ(flat.nss, 0.0);
  EXPECT_DOUBLE_EQ(flat.cc, 0.0);
}

TEST(SaliencyScores, TwoFixationsOfOnePixelCountTwiceForNss) {
  const cv::Mat1f map = (cv::Mat1f(1, 4) << 3, 1, 0, 0);  // mean 1, deviation sqrt(1.5)
  EXPECT_NEAR(score_salience(map, {{0, 0}, {0, 0}, {1, 0}}, kNoBlur_px).nss,
              4.0 / 3.0 / std::sqrt(1.5), 1e-6);
}

TEST(SaliencyScores, NeedAMapAndFixations) {
  EXPECT_THROW((void)score_salience({}, {{0, 0}}, 1.0), std::invalid_argument);
  EXPECT_THROW((void)score_salience(cv::Mat1f(2, 2, 0.0F), {}, 1.0), std::invalid_argument);
}

class FixationFolder : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] fs::path write(const std::string& text) const {
    std::ofstream(folder_ / "fixations.csv") << text;
    return folder_ / "fixations.csv";
  }
  [[nodiscard]] std::string error(const std::string& text) const {
    try {
      (void)read_fixations(write(text));
    } catch (const UserError& diagnostic) {
      return diagnostic.what();
    }
    return "none";
  }
  const std::string heading_ = "image,subject,order,x,y,duration_ms\n";
  fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("fixations_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(FixationFolder, IsReadByImage) {
  const Fixations fixations = read_fixations(
      write(heading_ + "a.jpg,1,1,10.5,20,100\r\nb.jpg,1,1,3,4,90\n\na.jpg,2,1,30,40.25,80\n"));
  ASSERT_EQ(fixations.size(), 2U);
  EXPECT_EQ(fixations.at("a.jpg"),
            (std::vector<cv::Point2d>{cv::Point2d(10.5, 20.0), cv::Point2d(30.0, 40.25)}));
  EXPECT_EQ(fixations.at("b.jpg").size(), 1U);
}

TEST_F(FixationFolder, TellsTheLineThatIsWrong) {
  EXPECT_THAT(error(heading_ + "a.jpg,1,1,10,20,5\na.jpg,1,2,here,20,5\n"),
              testing::HasSubstr("fixations.csv:3: x and y are no numbers"));
  EXPECT_THAT(error(heading_ + "a.jpg,1,1,nan,20,5\n"), testing::HasSubstr("fixations.csv:2"));
  EXPECT_THAT(error(heading_ + "a.jpg,1\n"), testing::HasSubstr("fixations.csv:2"));
  EXPECT_THAT(error("x,y\n"), testing::HasSubstr("fixations.csv:1"));
  EXPECT_THAT(error(heading_), testing::HasSubstr("holds no fixation"));
  EXPECT_THAT(error(""), testing::HasSubstr("is missing or empty"));
  EXPECT_THROW((void)read_fixations(folder_ / "nowhere.csv"), UserError);
}

TEST_F(FixationFolder, IsEvaluatedToATableAndAPlot) {
  cv::Mat3b image(90, 120, cv::Vec3b(90, 110, 100));
  image(cv::Rect(60, 30, 20, 20)).setTo(cv::Vec3b(20, 20, 220));
  cv::imwrite((folder_ / "a.png").string(), image);
  (void)write(heading_ + "a.png,1,1,70,40,200\na.png,1,2,66,44,200\n");
  const fs::path out = folder_ / "out";
  EXPECT_EQ(evaluate_saliency({folder_.string(), out.string()}), 0);
  EXPECT_TRUE(fs::is_regular_file(out / "saliency.csv"));
  EXPECT_TRUE(fs::is_regular_file(out / "saliency.svg"));
}

}  // namespace
}  // namespace striate::evaluation
