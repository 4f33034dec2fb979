#include "striate/app/perceive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "striate/base/user_error.hpp"
#include "tests/reference/scattered_pair.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;

class Perceive : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / (std::string("striate_perceive_") +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// A textured board before a textured background, `near_px` and `far_px` apart in the two eyes.
  void write_pair(int near_px, int far_px, int type = CV_8UC3) {
    cv::Mat1b left(240, 320);
    cv::Mat1b right(240, 320);
    for (int v = 0; v < 240; ++v) {
      for (int u = 0; u < 320; ++u) {
        left(v, u) = at(v, u, far_px, near_px, 0);
        right(v, u) = at(v, u, far_px, near_px, 1);
      }
    }
    options_.left = write(left, "left.png", type);
    options_.right = write(right, "right.png", type);
    options_.out = folder_ / "out" / "deep";
  }

  [[nodiscard]] fs::path write(const cv::Mat1b& grey, const std::string& name, int type) const {
    cv::Mat out = grey;
    if (CV_MAT_CN(type) == 3) cv::cvtColor(grey, out, cv::COLOR_GRAY2BGR);
    if (CV_MAT_CN(type) == 4) cv::cvtColor(grey, out, cv::COLOR_GRAY2BGRA);
    if (CV_MAT_DEPTH(type) == CV_16U) out.convertTo(out, CV_16U, 257.0);
    cv::imwrite((folder_ / name).string(), out);
    return folder_ / name;
  }

  static uchar at(int v, int u, int far_px, int near_px, int eye) {
    const int board = u + eye * near_px;  // column on the board's own texture
    const bool on_board = board >= 120 && board < 220 && v >= 60 && v < 200;
    const int own = on_board ? board + 5000 : u + eye * far_px;
    std::uint32_t x = static_cast<std::uint32_t>(own / 4) * 2654435761U +
                      static_cast<std::uint32_t>(v / 4) * 40503U;
    x = (x ^ (x >> 15)) * 0x2C1B3C6DU;
    return static_cast<uchar>(40 + (x >> 16) % 180);
  }

  [[nodiscard]] nlohmann::json read_json(const std::string& name) const {
    std::ifstream in(options_.out / name);
    return nlohmann::json::parse(in);
  }

  [[nodiscard]] cv::Mat1f read_pfm(const std::string& name) const {
    std::ifstream in(options_.out / name, std::ios::binary);
    std::string kind;
    int width = 0;
    int height = 0;
    double scale = 0.0;
    in >> kind >> width >> height >> scale;
    in.get();
    EXPECT_EQ(kind, "Pf");
    EXPECT_EQ(scale, -1.0);
    cv::Mat1f values(height, width);
    for (int v = height - 1; v >= 0; --v) {
      in.read(reinterpret_cast<char*>(values[v]), static_cast<std::streamsize>(4) * width);
    }
    EXPECT_TRUE(in.good());
    return values;
  }

  [[nodiscard]] std::string error() const {
    try {
      perceive(options_);
    } catch (const UserError& e) {
      return e.what();
    }
    return "";
  }

  fs::path folder_;
  PerceiveOptions options_;
};

TEST_F(Perceive, WritesDepthUprightInTheLeftImagesFrame) {
  write_pair(24, 8);
  EXPECT_FALSE(perceive(options_).frame.left.empty());
  const cv::Mat1f disparity = read_pfm("disparity.pfm");
  ASSERT_EQ(disparity.size(), cv::Size(160, 120));
  EXPECT_NEAR(disparity(65, 85), 12.0, 0.5);  // on the board, in px of the working size
  EXPECT_NEAR(disparity(12, 120), 4.0, 0.5);  // above the board: rows are not upside down
  EXPECT_EQ(read_pfm("confidence.pfm").size(), cv::Size(160, 120));
  for (const char* name : {"saliency.png", "overview.png"}) {
    EXPECT_FALSE(cv::imread((options_.out / name).string()).empty()) << name;
  }
}

TEST_F(Perceive, AnUnknownCameraGivesNearBlobsInBaselines) {
  write_pair(24, 8);
  perceive(options_);
  const nlohmann::json json = read_json("obstacles.json");
  EXPECT_EQ(json["unit"], "baselines");
  ASSERT_EQ(json["obstacles"].size(), 1U);
  EXPECT_NEAR(json["obstacles"][0]["from_u_px"].get<int>(), 60, 4);
  EXPECT_NEAR(json["obstacles"][0]["to_u_px"].get<int>(), 109, 4);
  EXPECT_GT(json["threshold_px"].get<double>(), 4.5);
  EXPECT_LT(json["threshold_px"].get<double>(), 12.0);
}

TEST_F(Perceive, AKnownCameraGivesMetres) {
  write_pair(24, 8);
  options_.focal_px = 400.0;
  options_.baseline_m = 0.12;
  for (const char* setting : {"paper", "robust"}) {
    options_.mode = setting;
    perceive(options_);
    const nlohmann::json json = read_json("obstacles.json");
    EXPECT_EQ(json["unit"], "m");
    ASSERT_FALSE(json["obstacles"].empty());
    EXPECT_NEAR(json["obstacles"][0]["distance"].get<double>(), 2.0, 0.15) << setting;
  }
  options_.camera_height_m = 1.0;
  perceive(options_);
  EXPECT_TRUE(read_json("obstacles.json")["floor_known"]);
}

// What is far away has a negative disparity in these images, as it may have in Middlebury's.
TEST_F(Perceive, ThePrincipalPointOfTheRightEyeCountsInEveryDistance) {
  write_pair(24 - 16, 8 - 16);
  options_.focal_px = 400.0;
  options_.baseline_m = 0.12;
  for (const bool as_difference : {true, false}) {
    options_.doffs_px.reset();
    options_.right_centre_u_px.reset();
    (as_difference ? options_.doffs_px : options_.right_centre_u_px) =
        as_difference ? 16.0 : 159.5 + 16.0;
    for (const char* setting : {"paper", "robust"}) {
      options_.mode = setting;
      perceive(options_);
      const nlohmann::json json = read_json("obstacles.json");
      ASSERT_FALSE(json["obstacles"].empty());
      EXPECT_NEAR(json["obstacles"][0]["distance"].get<double>(), 2.0, 0.15) << setting;
      EXPECT_NEAR(json["doffs_px"].get<double>(), 8.0, 1e-9);
    }
    const cv::Mat1f disparity = read_pfm("disparity.pfm");
    EXPECT_NEAR(disparity(65, 85), 4.0, 0.5) << "of the images as they are given";
    EXPECT_NEAR(disparity(12, 60), -4.0, 0.5);
  }
  options_.right_centre_u_px = 1e6;
  EXPECT_THAT(error(), testing::HasSubstr("--doffs-px"));
}

TEST_F(Perceive, WarnsOfEyesThatAreExchangedIdenticalOrOffTheirRows) {
  write_pair(24, 8);
  const reference::EyeImages eyes = reference::scattered_pair(6);
  const fs::path left = write(eyes.left, "l.png", CV_8UC3);
  const fs::path right = write(eyes.right, "r.png", CV_8UC3);
  cv::Mat1b lower;
  cv::copyMakeBorder(eyes.right.rowRange(0, 470), lower, 10, 0, 0, 0, cv::BORDER_REPLICATE);
  struct Pair {
    fs::path left, right;
    const char* says;
  };
  for (const Pair& pair : {Pair{left, right, ""},
                           {right, left, "exchanged"},
                           {left, left, "same picture"},
                           {left, write(lower, "low.png", CV_8UC3), "px lower"}}) {
    options_.left = pair.left;
    options_.right = pair.right;
    testing::internal::CaptureStderr();
    EXPECT_FALSE(perceive(options_).frame.left.empty());
    const std::string said = testing::internal::GetCapturedStderr();
    const nlohmann::json json = read_json("obstacles.json");
    EXPECT_EQ(json.contains("warnings"), *pair.says != '\0');
    EXPECT_THAT(said, testing::HasSubstr(pair.says));
    EXPECT_EQ(said.empty(), *pair.says == '\0') << said;
  }
}

TEST_F(Perceive, BothEyesOfTenBitsGetTheSameWhite) {
  write_pair(24, 8, CV_16UC1);
  for (const fs::path& file : {options_.left, options_.right}) {
    cv::Mat1w image = cv::imread(file.string(), cv::IMREAD_UNCHANGED);
    image /= 64;
    if (file == options_.right) image /= 4;  // dim: 8 bits of the 10
    cv::imwrite(file.string(), image);
  }
  EXPECT_FALSE(perceive(options_).frame.left.empty());
  EXPECT_NEAR(read_pfm("disparity.pfm")(65, 85), 12.0, 0.5);
}

TEST_F(Perceive, TakesGreySixteenBitAndAlpha) {
  for (const int type : {CV_8UC1, CV_16UC1, CV_16UC3, CV_8UC4}) {
    write_pair(24, 8, type);
    EXPECT_FALSE(perceive(options_).frame.left.empty());
    EXPECT_NEAR(read_pfm("disparity.pfm")(65, 85), 12.0, 0.5);
  }
}

TEST_F(Perceive, OneEyeGivesSaliencyAndNoDepth) {
  write_pair(24, 8);
  options_.right.clear();
  EXPECT_FALSE(perceive(options_).frame.left.empty());
  EXPECT_FALSE(fs::exists(options_.out / "disparity.pfm"));
  EXPECT_TRUE(read_json("obstacles.json")["obstacles"].empty());
  EXPECT_FALSE(cv::imread((options_.out / "overview.png").string()).empty());
  EXPECT_TRUE(read_json("keypoints.json")["keypoints"].is_array());
}

TEST_F(Perceive, SaysWhichImageIsWrongAndHow) {
  write_pair(24, 8);
  const fs::path good = options_.left;
  options_.left = folder_ / "nowhere.png";
  EXPECT_THAT(error(), testing::HasSubstr("nowhere.png: no such file"));
  options_.left = folder_ / "text.png";
  std::ofstream(options_.left) << "this is no image";
  EXPECT_THAT(error(), testing::HasSubstr("text.png: is no image"));
  options_.left = folder_;
  EXPECT_THAT(error(), testing::HasSubstr("is a folder"));
  options_.left = good;
  options_.right = write(cv::Mat1b(100, 100, uchar{7}), "small.png", CV_8UC1);
  EXPECT_THAT(error(), testing::HasSubstr("is 100 x 100"));
}

TEST_F(Perceive, RefusesImpossibleOptions) {
  write_pair(24, 8);
  const PerceiveOptions good = options_;
  options_.focal_px = 400.0;
  EXPECT_THAT(error(), testing::HasSubstr("--baseline-m"));
  options_ = good;
  options_.width_px = 5000;
  EXPECT_THAT(error(), testing::HasSubstr("--width-px"));
  options_ = good;
  options_.mode = "magic";
  EXPECT_THAT(error(), testing::HasSubstr("paper or robust"));
  options_ = good;
  std::ofstream(folder_ / "file") << "x";
  options_.out = folder_ / "file";
  EXPECT_THAT(error(), testing::HasSubstr("--out"));
}

TEST_F(Perceive, AWideCameraThatLooksDownIsSeenThrough) {
  write_pair(24, 8);
  options_.focal_px = 71.0;  // 132 degrees
  options_.baseline_m = 0.12;
  options_.camera_height_m = 1.0;
  for (const double tilt_deg : {-30.0, -60.0, 60.0}) {
    options_.tilt_deg = tilt_deg;
    EXPECT_FALSE(perceive(options_).frame.left.empty()) << tilt_deg;
  }
}

TEST_F(Perceive, ACameraThatCannotBeIsRefusedWithTheOptionsThatSayIt) {
  write_pair(24, 8);
  options_.focal_px = 400.0;
  options_.baseline_m = 0.12;
  options_.camera_height_m = 1.0;
  const PerceiveOptions good = options_;
  const double none = std::nan("");
  const std::vector<std::pair<const char*, std::function<void(PerceiveOptions&)>>> changes = {
      {"focal length is 2 px", [](auto& o) { o.focal_px = 2.0; }},
      {"focal length is 4e+06 px", [](auto& o) { o.focal_px = 4e6; }},
      {"focal length", [](auto& o) { o.focal_px = 1e300; }},
      {"distance of its eyes", [](auto& o) { o.baseline_m = 1e9; }},
      {"principal point, u", [](auto& o) { o.centre_u_px = -1e9; }},
      {"principal point, v", [=](auto& o) { o.centre_v_px = none; }},
      {"camera's height", [](auto& o) { o.camera_height_m = 1e-9; }}};
  for (const auto& [what, change] : changes) {
    options_ = good;
    change(options_);
    EXPECT_THAT(error(), testing::AllOf(testing::HasSubstr(what), testing::HasSubstr("--focal-px")))
        << what;
  }
  options_ = good;
  options_.tilt_deg = 170.0;
  EXPECT_THAT(error(), testing::HasSubstr("--tilt-deg 170: a camera is tilted by 60 degrees"));
}

}  // namespace
}  // namespace striate::app
