#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/images/pfm.hpp"
#include "striate/evaluation/stereo_methods.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder of this test's own; gone afterwards.
class EvalStereo : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::temp_directory_path() /
            (std::string("striate_stereo_") + info->name() + std::to_string(::getpid()));
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& file, const cv::Mat& image) const {
    fs::create_directories((root_ / file).parent_path());
    cv::imwrite((root_ / file).string(), image);
  }
  void write(const std::string& file, const std::string& content) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file, std::ios::binary) << content;
  }

  /// A texture that is 8 px further left in the right image.
  void write_pair(const std::string& folder, const std::string& left,
                  const std::string& right) const {
    write(folder + "/" + left, reference::texture(kSize, 1));
    write(folder + "/" + right, reference::texture(kSize, 1, kShift_px));
  }

  [[nodiscard]] static std::string pfm(cv::Size size, float value, bool big_endian) {
    std::string text = "Pf\n" + std::to_string(size.width) + " " + std::to_string(size.height) +
                       (big_endian ? "\n1.0\n" : "\n-1.0\n");
    std::string bytes(4, '\0');
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (std::size_t k = 0; k < 4; ++k) {
      bytes[big_endian ? 3 - k : k] = static_cast<char>(bits >> (8 * k) & 0xFF);
    }
    for (int k = 0; k < size.area(); ++k) text += bytes;
    return text;
  }

  [[nodiscard]] std::string diagnostic(const std::function<void()>& run) const {
    try {
      run();
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] std::string diagnostic_of_reading() const {
    return diagnostic([&] {
      for (const StereoFolder& folder : find_stereo_folders(root_).pairs) {
        (void)read_stereo_pair(folder, kSize);
      }
    });
  }

  static constexpr int kShift_px = 8;
  static inline const cv::Size kSize{80, 60};
  fs::path root_;
};

TEST_F(EvalStereo, FindsEveryLayoutInAnyDepthAndReadsItsUnits) {
  const cv::Mat1b seen(kSize, std::uint8_t{255});
  write_pair("a/of_2003", "imL.png", "imR.png");
  write("a/of_2003/groundtruth.png", cv::Mat1b(kSize, std::uint8_t{4 * kShift_px}));
  write("a/of_2003/nonocc.png", seen);
  write_pair("a/b/of_2006", "view1.png", "view5.png");
  write("a/b/of_2006/disp1.png", cv::Mat1b(kSize, std::uint8_t{3 * kShift_px}));
  write("a/b/of_2006/disp5.png", cv::Mat1b(kSize, std::uint8_t{3 * kShift_px}));
  write_pair("c", "left.png", "right.png");
  write("c/disparity.pfm", pfm(kSize, kShift_px, false));
  write_pair("d", "left.png", "right.png");
  write("e/00_left.png", seen);

  const StereoFolders found = find_stereo_folders(root_);
  ASSERT_EQ(found.pairs.size(), 3U);
  EXPECT_EQ(found.skipped.size(), 2U) << "d and e have no ground truth";
  for (const StereoFolder& folder : found.pairs) {
    const StereoPair pair = read_stereo_pair(folder, kSize);
    EXPECT_EQ(pair.truth_px(30, 40), kShift_px) << folder.name;
    if (folder.name != "of_2003") {
      EXPECT_TRUE(std::isnan(pair.truth_px(30, 2))) << folder.name << ": not seen by the right eye";
    }
    const StereoPair half = read_stereo_pair(folder, {40, 30});
    EXPECT_EQ(half.truth_px(15, 20), kShift_px / 2.0) << folder.name;
  }
}

TEST_F(EvalStereo, AllMethodsFindAShiftedTextureAndTheTablesAreWritten) {
  write_pair("pair", "left.png", "right.png");
  write("pair/disparity.pfm", pfm(kSize, kShift_px, true));
  const std::string out = (root_ / "out").string();
  ASSERT_EQ(evaluate_stereo({root_.string(), out}), 0);
  for (const char* file : {"stereo.csv", "stereo_pairs.csv", "stereo_calibration.csv", "stereo.svg",
                           "stereo_calibration.svg"}) {
    EXPECT_GT(fs::file_size(fs::path(out) / file), 100U) << file;
  }
  const std::vector<StereoPair> pairs = {
      read_stereo_pair(find_stereo_folders(root_).pairs.at(0), {160, 120})};
  EXPECT_EQ(disparities_to_search(pairs), 48);
  for (const StereoMethod& method : stereo_methods(160, 48)) {
    const StereoResult result = measure(method, pairs);
    EXPECT_LT(result.mean.bad2, 5.0) << method.name;
    EXPECT_GT(result.mean.density, 70.0) << method.name;
  }
}

TEST_F(EvalStereo, TellsTheLayoutWhereThereIsNoPair) {
  auto evaluate = [&](const std::string& folder) {
    return diagnostic([&] { (void)evaluate_stereo({folder, (root_ / "out").string()}); });
  };
  EXPECT_THAT(evaluate(root_.string()), HasSubstr("groundtruth.png"));
  EXPECT_THAT(evaluate((root_ / "missing").string()), HasSubstr("no such folder"));
  write_pair("d", "left.png", "right.png");
  EXPECT_THAT(evaluate(root_.string()), HasSubstr("disparity.pfm"));
}

TEST_F(EvalStereo, NamesTheImageThatDoesNotFit) {
  write("p/left.png", reference::texture(kSize, 1));
  write("p/right.png", reference::texture({70, 60}, 1));
  write("p/disparity.pfm", pfm(kSize, 3.0F, false));
  EXPECT_THAT(diagnostic_of_reading(), HasSubstr("right.png is 70 x 60"));
  write("p/right.png", reference::texture(kSize, 1));
  write("p/disparity.pfm", pfm({10, 10}, 3.0F, false));
  EXPECT_THAT(diagnostic_of_reading(), HasSubstr("disparity.pfm is 10x10"));
  write("p/right.png", std::string("no image"));
  EXPECT_THAT(diagnostic_of_reading(), HasSubstr("right.png: is no image that can be read"));
}

TEST_F(EvalStereo, RefusesABrokenPfm) {
  auto refused = [&](const std::string& content) {
    write("broken.pfm", content);
    return diagnostic([&] { (void)read_pfm(root_ / "broken.pfm"); });
  };
  EXPECT_THAT(refused(""), HasSubstr("does not begin with Pf; a grey PFM file is needed"));
  EXPECT_THAT(refused("PF\n2 2\n-1.0\n"), HasSubstr("three channels"));
  EXPECT_THAT(refused("Pf\n2 2\n0\n"), HasSubstr("its scale is"));
  EXPECT_THAT(refused("Pf\n-2 2\n-1.0\n"), HasSubstr("its width or height is no number"));
  EXPECT_THAT(refused("Pf\n99999999 2\n-1.0\n"), HasSubstr("larger than 16384 px"));
  EXPECT_THAT(refused("Pf\n9000 9000\n-1.0\nabc"), HasSubstr("more than 40 million pixels"));
  const std::string whole = pfm({3, 2}, 1.5F, false);
  EXPECT_THAT(refused(whole.substr(0, whole.size() - 1)), HasSubstr("ends too early"));
  EXPECT_EQ(refused(whole), "");
}

TEST_F(EvalStereo, ReadsAPfmOfEitherByteOrder) {
  for (const bool big_endian : {false, true}) {
    write("one.pfm", pfm({3, 2}, 1.5F, big_endian));
    EXPECT_EQ(read_pfm(root_ / "one.pfm")(1, 2), 1.5F);
  }
}

TEST(StereoScore, CountsWhatIsWrongAndHowSureItWas) {
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat1f truth = (cv::Mat1f(1, 5) << 5.0F, 5.0F, 5.0F, 5.0F, unknown);
  const cv::Mat1f found = (cv::Mat1f(1, 5) << 5.5F, 6.5F, 8.0F, perception::kNoMatch, 5.0F);
  const StereoScore score = judge(found, truth);
  EXPECT_NEAR(score.bad1, 200.0 / 3.0, 1e-9);
  EXPECT_NEAR(score.bad2, 100.0 / 3.0, 1e-9);
  EXPECT_NEAR(score.density, 75.0, 1e-9);
  Calibration calibration;
  calibration.add(found, (cv::Mat1f(1, 5) << 1.0F, 0.35F, 0.3F, 0.0F, 0.9F), truth);
  EXPECT_EQ(calibration.bins()[9].count, 1);
  EXPECT_EQ(calibration.bins()[9].right, 1);
  EXPECT_EQ(calibration.bins()[3].count, 2);
  EXPECT_EQ(calibration.bins()[3].right, 0);
}

}  // namespace
}  // namespace striate::evaluation
