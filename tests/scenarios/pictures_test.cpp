#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/reference/board_camera.hpp"
#include "tests/reference/scattered_pair.hpp"
#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

void write_image(const std::string& file, const cv::Mat& image) {
  fs::create_directories(fs::path(file).parent_path());
  cv::imwrite(file, image);
}

/// Six looks of two cameras at a board; the right images come `late` looks after the left ones.
void write_boards(const std::string& folder, int late) {
  constexpr int kLooks = 6;
  const cv::Size size(320, 240);
  pioneer::CameraModel lens;
  lens.matrix = {400.0, 0.0, 160.0, 0.0, 400.0, 120.0, 0.0, 0.0, 1.0};
  const reference::BoardCamera camera(lens, size);
  for (int i = 0; i < kLooks; ++i) {
    for (const bool is_right : {false, true}) {
      const int k = is_right ? (i + late) % kLooks : i;
      cv::Matx33d turn;
      cv::Rodrigues(cv::Vec3d(0.4 * std::sin(1.3 * k), 0.4 * std::cos(1.7 * k), 0.1 * k), turn);
      const cv::Vec3d middle(0.05 + 0.06 * std::sin(2.0 * k), 0.05 * std::cos(2.6 * k),
                             0.9 + 0.1 * (k % 3));
      const cv::Vec3d way = middle - turn * cv::Vec3d(2.5 * 0.05, 1.5 * 0.05, 0.0) -
                            cv::Vec3d(is_right ? 0.12 : 0.0, 0.0, 0.0);
      write_image(folder + (is_right ? "/right/" : "/left/") + std::to_string(i) +
                      (is_right ? ".JPG" : ".PNG"),
                  camera.image(6, 4, 0.05, turn, way));
    }
  }
}

Ended calibrate(const TemporaryFolder& folder) {
  return striate({"calibrate", folder.path(), "--columns", "6", "--rows", "4", "--square-mm", "50",
                  "--out", folder / "stereo.yaml"});
}

TEST(Calibrate, ReadsSuffixesOfEveryKindAndNamesTheImageWithoutAPartner) {
  const TemporaryFolder folder;
  write_boards(folder.path(), 0);
  write_image(folder / "left/extra.png", cv::Mat1b(240, 320, uchar{100}));
  const Ended ended = calibrate(folder);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("left/extra.png"));
  EXPECT_THAT(ended.out, HasSubstr("6 pairs of 320 x 240 px"));
  EXPECT_TRUE(fs::exists(folder / "stereo.yaml"));
}

TEST(Calibrate, WritesNothingWhereTheRightImagesCameAMomentLate) {
  const TemporaryFolder folder;
  write_boards(folder.path(), 1);
  const Ended ended = calibrate(folder);
  EXPECT_EQ(ended.exit_code, 2) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr("same moment"));
  EXPECT_FALSE(fs::exists(folder / "stereo.yaml"));
}

TEST(TeachFromPictures, LearnsThePartThatIsSaidAndTellsHowMuchThatIs) {
  const TemporaryFolder folder;
  write_image(folder / "p.png", reference::scattered_pair(1).left);
  const auto teach = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"teach", "card", "--memory", folder / "m.db"});
    return striate(words);
  };
  const std::string image = folder / "p.png";
  const Ended part = teach({"--image", image, "--crop", "160,120,320,240"});
  EXPECT_EQ(part.exit_code, 0) << part.err;
  EXPECT_THAT(part.out, HasSubstr("p.png: kept 25 % of the picture"));
  EXPECT_THAT(teach({"--image", image, "--whole"}).out, HasSubstr("kept 100 % of the picture"));
  for (const auto& [crop, why] :
       {std::pair<const char*, const char*>{"400,120,320,240", "goes beyond"},
        {"1,2,3", "four whole numbers"},
        {"4294967297,0,10,10", "four whole numbers"},
        {"1,2,3,4,", "four whole numbers"},
        {"0,0,-5,5", "four whole numbers"}}) {
    const Ended wrong = teach({"--image", image, "--crop", crop});
    EXPECT_EQ(wrong.exit_code, 2) << crop;
    EXPECT_THAT(wrong.err, HasSubstr(why));
  }
  EXPECT_EQ(teach({"--image", image, "--image", image, "--image", image, "--crop", "0,0,99,99",
                   "--crop", "0,0,99,99"})
                .exit_code,
            2);
}

TEST(PerceivePictures, SaysThatTheEyesAreExchanged) {
  const TemporaryFolder folder;
  const reference::EyeImages eyes = reference::scattered_pair(1);
  write_image(folder / "l.png", eyes.left);
  write_image(folder / "r.png", eyes.right);
  const Ended ended = striate({"perceive", "--left", folder / "r.png", "--right", folder / "l.png",
                               "--out", folder / "out"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.err, HasSubstr("exchanged"));
  EXPECT_THAT(read_text(folder / "out/obstacles.json"), HasSubstr("exchanged"));
}

}  // namespace
}  // namespace striate::scenarios
