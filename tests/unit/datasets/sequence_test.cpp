#include "striate/platform/datasets/sequences/sequence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "striate/base/user_error.hpp"
#include "tests/reference/temporary_folder.hpp"
#include "tests/reference/write_motion_jpeg.hpp"
#include "tests/unit/datasets/calibration_texts.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

/// A picture whose grey tells which one it is.
void picture(const fs::path& file, int grey, cv::Size size = {32, 24}) {
  fs::create_directories(file.parent_path());
  cv::imwrite(file.string(), cv::Mat1b(size, static_cast<uchar>(grey)));
}

struct Seen {
  std::vector<int> left;   ///< grey of each
  std::vector<int> right;  ///< -1: none
  std::vector<std::string> remarks;
  std::vector<std::string> left_out;
  std::string kind;
  std::string calibration;
};

Seen all_of(const fs::path& path, const SequenceOptions& options = {}) {
  const auto sequence = open_sequence(path, options);
  Seen seen;
  SequenceLook look;
  while (sequence->next(look)) {
    seen.left.push_back(look.left(5, 5)[0]);
    seen.right.push_back(look.right.empty() ? -1 : look.right(5, 5)[0]);
  }
  seen.remarks = sequence->remarks();
  seen.left_out = sequence->left_out();
  seen.kind = sequence->kind();
  seen.calibration = sequence->calibration_file();
  return seen;
}

using Greys = std::vector<int>;

class NamedEyes : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(NamedEyes, ArePairedAndPutInOrder) {
  const reference::TemporaryFolder folder;
  const auto [left, right] = GetParam();
  // 2 stands before 10, and the third pair has no right picture.
  for (const int k : {1, 2, 10}) {
    const auto name = [&](std::string pattern) {
      return folder / pattern.replace(pattern.find('*'), 1, std::to_string(k));
    };
    picture(name(left), 10 * k);
    if (k != 10) picture(name(right), 10 * k + 5);
  }
  const Seen seen = all_of(folder.path());
  EXPECT_EQ(seen.left, (Greys{10, 20})) << seen.kind;
  EXPECT_EQ(seen.right, (Greys{15, 25})) << seen.kind;
  EXPECT_THAT(seen.remarks, Contains(HasSubstr("no partner"))) << seen.kind;
}

INSTANTIATE_TEST_SUITE_P(
    Folders, NamedEyes,
    testing::Values(std::pair("left/*.png", "right/*.png"),
                    std::pair("Left/a*.png", "Right/a*.png"),
                    std::pair("cam0/data/*.pgm", "cam1/data/*.pgm"),
                    std::pair("image_left/*_left.png", "image_right/*_right.png"),
                    std::pair("L/*.png", "R/*.png"), std::pair("infra1/*.png", "infra2/*.png"),
                    std::pair("image_2/00000*.png", "image_3/00000*.png"),
                    std::pair("image_00/data/*.png", "image_01/data/*.png"),
                    std::pair("camera_0/x*.bmp", "camera_1/x*.bmp"),
                    std::pair("left_*.png", "right_*.png"), std::pair("*_l.png", "*_r.png"),
                    std::pair("im*L.png", "im*R.png"), std::pair("cam0_*.png", "cam1_*.png"),
                    std::pair("frame*-LEFT.png", "frame*-RIGHT.png"), std::pair("l*.png", "r*.png"),
                    std::pair("*_0.png", "*_1.png")));

TEST(OpenSequence, ReadsEuRocWithItsTimesGapsAndEyesOutOfStep) {
  const reference::TemporaryFolder folder;
  std::string left = "#timestamp [ns],filename\r\n";
  std::string right = left;
  constexpr std::int64_t kFirst_ns = 1403636579763555584;
  for (int k = 0; k < 8; ++k) {
    if (k == 4 || k == 5) continue;  // a gap
    const std::int64_t stamp_ns = kFirst_ns + k * 50'000'000LL;
    const std::string name = std::to_string(stamp_ns);
    left += name + "," + name + ".png\r\n";
    picture(folder / ("mav0/cam0/data/" + name + ".png"), 10 * k);
    const std::string other = std::to_string(stamp_ns + 2'000'000);
    right += other + "," + other + ".png\r\n";
    picture(folder / ("mav0/cam1/data/" + other + ".png"), 10 * k + 5);
  }
  (void)folder.write("mav0/cam0/data.csv", left);
  (void)folder.write("mav0/cam1/data.csv", right);
  const Seen seen = all_of(folder.path());
  EXPECT_EQ(seen.left, (Greys{0, 10, 20, 30, 60, 70}));
  EXPECT_EQ(seen.right, (Greys{5, 15, 25, 35, 65, 75}));
  EXPECT_THAT(seen.remarks, Contains(HasSubstr("out of step by up to 2.0 ms")));
  EXPECT_THAT(seen.remarks, Contains(HasSubstr("1 gap in time, the longest 0.15 s")));
  SequenceOptions options;
  options.from = SequencePlace{0.09, true};
  options.to = SequencePlace{0.31, true};
  EXPECT_EQ(all_of(folder / "mav0", options).left, (Greys{20, 30, 60}));
  options = {};
  options.every = 2;
  options.from = SequencePlace{1, false};
  options.to = SequencePlace{4, false};
  EXPECT_EQ(all_of(folder / "mav0", options).left, (Greys{20, 60}));
  (void)folder.write("mav0/cam0/data.csv", "#t,f\n1403636579763555584,a.png\nnoon,b.png\n");
  try {
    (void)all_of(folder.path());
    FAIL();
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), HasSubstr("data.csv:3:1: 'noon' is no time in ns"));
  }
}

TEST(OpenSequence, APictureThatCannotBeReadIsLeftOutAndSaid) {
  const reference::TemporaryFolder folder;
  for (const int k : {1, 2, 3, 4}) {
    picture(folder / ("left/" + std::to_string(k) + ".png"), 10 * k);
    picture(folder / ("right/" + std::to_string(k) + ".png"), 10 * k);
  }
  (void)folder.write("right/2.png", "no picture");
  picture(folder / "left/3.png", 30, {48, 24});
  picture(folder / "right/3.png", 30, {48, 24});
  const Seen seen = all_of(folder.path());
  EXPECT_EQ(seen.left, (Greys{10, 40}));
  ASSERT_EQ(seen.left_out.size(), 2U);
  EXPECT_THAT(seen.left_out[0], HasSubstr("right/2.png: is no image that can be read"));
  EXPECT_THAT(seen.left_out[1], HasSubstr("left/3.png: is 48 x 24 px, the first one was 32 x 24"));
}

TEST(OpenSequence, KittiHasTheCalibrationOfTheCamerasThatAreThere) {
  const reference::TemporaryFolder folder;
  for (const int k : {0, 1}) {
    picture(folder / ("image_2/00000" + std::to_string(k) + ".png"), 10 * k, {120, 40});
    picture(folder / ("image_3/00000" + std::to_string(k) + ".png"), 10 * k, {120, 40});
  }
  (void)folder.write("times.txt", "0.000000e+00\n1.036224e-01\n2.07e-01\n");
  (void)folder.write("calib.txt",
                     "P0: 70 0 60 0 0 70 20 0 0 0 1 0\nP1: 70 0 60 -38 0 70 20 0 0 0 1 0\n"
                     "P2: 70 0 60 4.5 0 70 20 0 0 0 1 0\nP3: 70 0 60 -33.3 0 70 20 0 0 0 1 0\n"
                     "Tr: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  const auto sequence = open_sequence(folder.path(), {});
  ASSERT_TRUE(sequence->calibration());
  EXPECT_NEAR(sequence->calibration()->baseline_m, 37.8 / 70.0, 1e-12);
  SequenceLook look;
  ASSERT_TRUE(sequence->next(look));
  ASSERT_TRUE(sequence->next(look));
  EXPECT_EQ(look.stamp_ns, 103'622'400);
}

TEST(OpenSequence, FindsTheCalibrationInAFolderByItsContentAndNotWhereTwoMightBeMeant) {
  const reference::TemporaryFolder folder;
  picture(folder / "left/1.png", 1, {640, 480});
  picture(folder / "right/1.png", 2, {640, 480});
  (void)folder.write("notes.txt", "P: taken in the rain\n");
  (void)folder.write("whatever.yaml", written::kalibr());
  EXPECT_EQ(all_of(folder.path()).calibration, folder / "whatever.yaml");
  (void)folder.write("old.xml", written::boofcv());
  EXPECT_EQ(all_of(folder.path()).calibration, "");
  EXPECT_THAT(all_of(folder.path()).remarks, Contains(HasSubstr("none was taken")));
}

TEST(OpenSequence, BothEyesMayStandSideBySideWhenSaidOrWhenTheCalibrationIsOfHalfTheWidth) {
  const reference::TemporaryFolder folder;
  cv::Mat1b both(480, 1280, uchar{10});
  both.colRange(640, 1280).setTo(20);
  fs::create_directories(folder / "p");
  cv::imwrite(folder / "p/1.png", both);
  EXPECT_EQ(all_of(folder / "p").right, (Greys{-1}));
  SequenceOptions options;
  options.side_by_side = true;
  EXPECT_EQ(all_of(folder / "p", options).right, (Greys{20}));
  options.exchanged = true;
  EXPECT_EQ(all_of(folder / "p", options).left, (Greys{20}));
  (void)folder.write("p/rig.yaml", written::kalibr());
  EXPECT_EQ(all_of(folder / "p").right, (Greys{20}));
  EXPECT_EQ(all_of(folder / "p/1.png").left, (Greys{10}));
}

TEST(OpenSequence, ReadsVideosOfBothEyes) {
  const reference::TemporaryFolder folder;
  std::vector<cv::Mat> video;
  for (int k = 0; k < 6; ++k) {
    cv::Mat3b frame(48, 128, cv::Vec3b::all(static_cast<uchar>(40 * k)));
    frame.colRange(64, 128).setTo(cv::Scalar::all(40 * k + 20));
    video.push_back(frame);
  }
  reference::write_motion_jpeg(folder / "both.avi", video, 10);
  SequenceOptions options;
  options.side_by_side = true;
  options.every = 2;
  const Seen seen = all_of(folder / "both.avi", options);
  ASSERT_EQ(seen.left.size(), 3U);
  EXPECT_NEAR(seen.left[1], 80, 3);
  EXPECT_NEAR(seen.right[1], 100, 3);
  options.from = SequencePlace{0.35, true};
  EXPECT_EQ(all_of(folder / "both.avi", options).left.size(), 1U);
}

TEST(OpenSequence, SaysWhatIsThereWhereNothingCanBePutInOrder) {
  const reference::TemporaryFolder folder;
  (void)folder.write("readme.md", "x");
  try {
    (void)all_of(folder.path());
    FAIL();
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), HasSubstr("in it are readme.md"));
  }
  EXPECT_THROW((void)all_of(folder / "none"), UserError);
}

}  // namespace
}  // namespace striate::datasets
