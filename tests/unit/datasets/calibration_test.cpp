#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/read_calibration.hpp"
#include "tests/unit/datasets/calibration_texts.hpp"

namespace striate::datasets {
namespace {

using testing::HasSubstr;

StereoModel read_texts(const std::vector<std::string>& texts) {
  const std::vector<std::string> names = {"a.yaml", "b.yaml"};
  return read_calibration_text(texts,
                               {names.begin(), names.begin() + static_cast<long>(texts.size())});
}

std::string mistake_in(const std::vector<std::string>& texts) {
  try {
    (void)read_texts(texts);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

void expect_the_cameras(const StereoModel& model, const std::string& of) {
  ASSERT_TRUE(model.right && model.apart) << of;
  EXPECT_LT(cv::norm(model.left.matrix - written::kLeft), 1e-9) << of;
  EXPECT_LT(cv::norm(model.right->matrix - written::kRight), 1e-9) << of;
  ASSERT_GE(model.left.distortion.size(), 4U) << of;
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(model.left.distortion[static_cast<std::size_t>(k)], written::kLensLeft[k]) << of;
    EXPECT_EQ(model.right->distortion[static_cast<std::size_t>(k)], written::kLensRight[k]) << of;
  }
  EXPECT_LT(cv::norm(model.apart->rotation - written::kTurn), 1e-9) << of;
  EXPECT_LT(cv::norm(model.apart->translation_m - written::kWay), 1e-9) << of;
  EXPECT_EQ(model.left.size_px, cv::Size(640, 480)) << of;
}

/// Other versions of it write <r> and <t>.
std::string small_letters_of_boofcv() {
  std::string text = written::boofcv();
  for (const auto& [from, to] : {std::pair("<R>", "<r>"), std::pair("</R>", "</r>"),
                                 std::pair("<T>", "<t>"), std::pair("</T>", "</t>")}) {
    text = replaced(text, from, to);
  }
  return text;
}

struct WrittenBy {
  const char* program;
  std::vector<std::string> texts;
};

std::vector<WrittenBy> of_all_programs() {
  using namespace written;
  const cv::Matx44d body = motion(kTurn.t() * kTurn.t(), {0.3, -0.2, 0.1});
  cv::Matx44d second = motion(kTurn, kWay).inv();
  return {{"OpenCV's sample", {opencv("M1", "D1", "M2", "D2")}},
          {"short names", {opencv("K1", "D1", "K2", "D2")}},
          {"counted from zero", {opencv("K0", "D0", "K1", "D1")}},
          {"letters", {opencv("Kl", "Dl", "Kr", "Dr")}},
          {"a blog", {opencv("cameraMatrixL", "distCoeffsL", "cameraMatrixR", "distCoeffsR")}},
          {"ours",
           {opencv("left_camera_matrix", "left_distortion", "right_camera_matrix",
                   "right_distortion")}},
          {"words behind", {opencv("K_left", "dist_left", "K_right", "dist_right")}},
          {"ORB-SLAM", {opencv("LEFT.K", "LEFT.D", "RIGHT.K", "RIGHT.D")}},
          {"XML", {opencv_as_xml()}},
          {"JSON", {json()}},
          {"Kalibr", {kalibr()}},
          {"BoofCV", {boofcv()}},
          {"BoofCV with small letters", {small_letters_of_boofcv()}},
          {"EuRoC", {euroc(kLeft, kLensLeft, body), euroc(kRight, kLensRight, body * second)}}};
}

TEST(ReadCalibration, GivesTheSameCamerasWhoeverWroteThemDown) {
  for (const WrittenBy& one : of_all_programs()) {
    expect_the_cameras(read_texts(one.texts), one.program);
  }
}

TEST(ReadCalibration, LineEndsOfWindowsAMarkOfByteOrderAndAMissingLastLineEndChangeNothing) {
  for (const WrittenBy& one : of_all_programs()) {
    std::vector<std::string> windows;
    for (const std::string& text : one.texts) {
      std::string changed = "\xEF\xBB\xBF";
      for (const char c : text) changed += c == '\n' ? std::string("\r\n") : std::string(1, c);
      while (changed.ends_with("\r\n")) changed.resize(changed.size() - 2);
      windows.push_back(changed);
    }
    expect_the_cameras(read_texts(windows), one.program);
  }
}

TEST(ReadCalibration, MillimetresAreTakenForWhatTheyAreAndSaid) {
  std::string text = written::opencv("M1", "D1", "M2", "D2");
  const std::string metres = written::numbers(written::kWay);
  text = replaced(text, metres, written::numbers(written::kWay * 1000.0));
  const StereoModel model = read_texts({text});
  expect_the_cameras(model, "mm");
  EXPECT_THAT(model.remarks, testing::Contains(HasSubstr("taken for mm")));
}

/// What stereoRectify makes of a pair with this focal length and baseline.
std::vector<std::string> infos(double focal_px, double shift, bool message = false) {
  using namespace written;
  const cv::Matx34d left(focal_px, 0, 300, 0, 0, focal_px, 240, 0, 0, 0, 1, 0);
  const cv::Matx34d right(focal_px, 0, 310, shift, 0, focal_px, 240, 0, 0, 0, 1, 0);
  const auto write = message ? camera_info_message : camera_info;
  return {write(kLeft, kLensLeft, kTurn, left), write(kRight, kLensRight, kTurn.t(), right)};
}

TEST(ReadCalibration, TheBaselineOfRosStandsInThePOfTheRightEyeInWhicheverOrderTheFilesAreGiven) {
  for (const bool message : {false, true}) {
    std::vector<std::string> texts = infos(400.0, -48.0, message);
    for (int order = 0; order < 2; ++order) {
      const StereoModel model = read_texts(texts);
      EXPECT_NEAR(model.baseline_m, 0.12, 1e-12);
      EXPECT_NEAR(model.doffs_px, 10.0, 1e-12);
      EXPECT_LT(cv::norm(model.left.matrix - written::kLeft), 1e-9);
      EXPECT_FALSE(model.pictures_rectified);
      std::swap(texts[0], texts[1]);
    }
  }
}

TEST(ReadCalibration, WhatAFileLacksIsSaid) {
  EXPECT_THAT(read_texts({infos(400.0, -48.0)[0]}).remarks,
              testing::Contains(HasSubstr("one eye alone")));
  EXPECT_THAT(read_texts({infos(400.0, -48.0)[1]}).remarks,
              testing::Contains(HasSubstr("right eye's")));
  EXPECT_THAT(read_texts(infos(400.0, 0.0)).remarks, testing::Contains(HasSubstr("no baseline")));
  EXPECT_THAT(mistake_in({replaced(written::kalibr(), "T_cn_cnm1", "T_other")}),
              HasSubstr("a.yaml:9:1: error: cam1 does not say where it is"));
  EXPECT_THAT(mistake_in({replaced(written::opencv("M1", "D1", "M2", "D2"), "T: !!", "Txx: !!")}),
              HasSubstr("does not tell how the eyes stand to each other"));
  EXPECT_THAT(mistake_in({"fruit: apple\ncount: 3\n"}), HasSubstr("it has fruit, count"));
}

TEST(ReadCalibration, TheRightEyeNamedFirstIsPutRightWhereThatIsCertainAndElseRefused) {
  using namespace written;
  const cv::Matx44d left = cv::Matx44d::eye();
  const cv::Matx44d right = motion(cv::Matx33d::eye(), {0.11, 0, 0});
  const StereoModel model =
      read_texts({euroc(kRight, kLensRight, right), euroc(kLeft, kLensLeft, left)});
  EXPECT_TRUE(model.eyes_exchanged);
  EXPECT_LT(cv::norm(model.left.matrix - kLeft), 1e-9);
  EXPECT_NEAR(model.apart->translation_m[0], -0.11, 1e-12);
  const std::string text =
      replaced(opencv("M1", "D1", "M2", "D2"), "data: [ -0.12", "data: [ 0.12");
  EXPECT_THAT(mistake_in({text}), HasSubstr("its right camera stands left of the left one"));
  EXPECT_NO_THROW((void)read_calibration_text({text}, {"a"}, true));
}

struct Broken {
  const char* what;
  const char* by;
  const char* message;
};

TEST(ReadCalibration, MistakesAreToldWithTheirPlace) {
  const Broken kalibr[] = {
      {"camera_model: pinhole", "camera_model: omni",
       "a.yaml:3:17: error: the camera model 'omni'"},
      {"radtan", "fov", "a.yaml:5:21: error: the lens model 'fov' is not known"},
      {"resolution: [640, 480]", "resolution: [640]", "a.yaml:7:15: error: 'resolution' must be"},
      {"resolution: [640, 480]", "resolution: [640, x]", "a.yaml:7:21: error: the size"},
      {"-0.28", ".nan", "a.yaml:4:23: error: '.nan' is no number"},
      {"[458.5, ", "[", "a.yaml:6:15: error: intrinsics (fu, fv, cu, cv) has 3 numbers"},
      {"[458.5, ", "[-458.5, ", "focal length is -458.5"},
      {"320.25", "32000.25", "lies far outside its 640 x 480 px"},
      {"  - [0, 0, 0, 1]\n", "  - [0, 0, 0, 2]\n", "its last row is not 0, 0, 0, 1"}};
  for (const Broken& one : kalibr) {
    EXPECT_THAT(mistake_in({replaced(written::kalibr(), one.what, one.by)}),
                HasSubstr(one.message));
  }
  const std::string xml = written::opencv_as_xml();
  EXPECT_THAT(mistake_in({xml.substr(0, xml.size() / 2)}), HasSubstr("error: not readable as XML"));
  EXPECT_THAT(mistake_in({replaced(xml, "</rows>", "</row>")}),
              HasSubstr("a.yaml:7:10: error: not readable as XML: </row> closes <rows>"));
  EXPECT_THAT(mistake_in({replaced(written::boofcv(), "0.9998", "0.7998")}),
              HasSubstr("is no rotation"));
  EXPECT_THAT(mistake_in({replaced(written::opencv("M1", "D1", "M2", "D2"), "-0.12, 0.001",
                                   "0.001, -0.12")}),
              HasSubstr("not side by side"));
}

TEST(ReadCalibration, ANumberThatIsNoneIsToldWithItsPlaceAlsoWhereItStandsAlone) {
  EXPECT_THAT(mistake_in({"fx: .nan\nfy: 400\ncx: 320\ncy: 240\n"}),
              HasSubstr("a.yaml:1:5: error: fx: '.nan' is no number"));
  EXPECT_THAT(mistake_in({"fx: 400\nfy: 400\ncx: 320\ncy: 240\nbaseline: 12 cm\n"}),
              HasSubstr("a.yaml:5:11: error: baseline: '12 cm' is no number"));
  EXPECT_THAT(mistake_in({replaced(written::boofcv(), "<t1>0.0", "<t1>x")}), HasSubstr("t1: 'x"));
}

TEST(ReadCalibration, EyesInOnePlaceAreRefused) {
  EXPECT_THAT(
      mistake_in({replaced(written::opencv("M1", "D1", "M2", "D2"), "-0.12, 0.001", "0, 0")}),
      HasSubstr("the eyes stand"));
  EXPECT_THAT(mistake_in({"K1: [400, 0, 320, 0, 400, 240, 0, 0, 1]\n"
                          "K2: [400, 0, 320, 0, 400, 240, 0, 0, 1]\n"
                          "R: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [0, 0, 0]\n"}),
              HasSubstr("the eyes stand 0 m apart"));
}

TEST(ReadCalibration, KittiAndMiddleburyTellOfPicturesThatAreRectified) {
  const std::string kitti =
      "P0: 707.0912 0 601.8873 0 0 707.0912 183.1104 0 0 0 1 0\n"
      "P1: 707.0912 0 601.8873 -379.8145 0 707.0912 183.1104 0 0 0 1 0\n";
  const StereoModel grey = read_texts({kitti});
  EXPECT_TRUE(grey.pictures_rectified);
  EXPECT_NEAR(grey.baseline_m, 379.8145 / 707.0912, 1e-12);
  EXPECT_THAT(mistake_in({replaced(kitti, "707.0912 0", "7o7 0")}),
              HasSubstr("a.yaml:1:5: error: '7o7' is no number"));
  EXPECT_THAT(mistake_in({kitti.substr(0, kitti.find("P1"))}), HasSubstr("'P1'"));
  const StereoModel motorcycle = read_texts(
      {"cam0=[994.978 0 311.193; 0 994.978 254.877; 0 0 1]\ncam1=[994.978 0 342.279; 0 994.978 "
       "254.877; 0 0 1]\ndoffs=31.086\nbaseline=193.001\nwidth=741\nheight=497\nndisp=70\n"});
  EXPECT_NEAR(motorcycle.baseline_m, 0.193001, 1e-12);
  EXPECT_NEAR(motorcycle.doffs_px, 31.086, 1e-9);
}

TEST(ReadCalibration, ARectifiedPairMayTellItsProjectionsAloneOrQ) {
  using namespace written;
  const cv::Matx34d left(400, 0, 320, 0, 0, 400, 240, 0, 0, 0, 1, 0);
  const cv::Matx34d right(400, 0, 325, -40, 0, 400, 240, 0, 0, 0, 1, 0);
  const cv::Matx44d q(1, 0, 0, -320, 0, 1, 0, -240, 0, 0, 0, 400, 0, 0, 10, 50);
  const StereoModel by_p = read_texts({opencv_yaml("P1", left) + opencv_yaml("P2", right)});
  const StereoModel by_q = read_texts({opencv_yaml("Q", q)});
  for (const StereoModel* model : {&by_p, &by_q}) {
    EXPECT_TRUE(model->pictures_rectified);
    EXPECT_NEAR(model->baseline_m, 0.1, 1e-12);
    EXPECT_NEAR(model->doffs_px, 5.0, 1e-9);
    EXPECT_EQ(model->left.matrix(0, 2), 320.0);
  }
}

TEST(ReadCalibration, EveryLensHasItsNumberOfCoefficients) {
  const auto lens = [](const std::string& model, const std::string& k) {
    return fmt::format(
        "image_width: 640\nimage_height: 480\ncamera_matrix: {{rows: 3, cols: 3, data: [400, 0, "
        "320, 0, 400, 240, 0, 0, 1]}}\ndistortion_model: {}\ndistortion_coefficients: [{}]\n",
        model, k);
  };
  EXPECT_EQ(read_texts({lens("plumb_bob", "0, 0, 0, 0, 0")}).left.lens, Lens::straight);
  EXPECT_EQ(read_texts({lens("none", "")}).left.lens, Lens::straight);
  EXPECT_EQ(
      read_texts({lens("rational_polynomial", "1, 2, 3, 4, 5, 6, 7, 8")}).left.distortion.size(),
      8U);
  EXPECT_EQ(read_texts({lens("equidistant", "0.1, 0, 0, 0")}).left.lens, Lens::equidistant);
  EXPECT_EQ(read_texts({lens("fisheye", "0, 0, 0, 0")}).left.lens, Lens::equidistant);
  EXPECT_THAT(mistake_in({lens("equidistant", "1, 2, 3, 4, 5")}), HasSubstr("has 5 coefficients"));
  EXPECT_THAT(mistake_in({lens("plumb_bob", "1, 2, 3, 4, 5, 6")}), HasSubstr("has 6 coefficients"));
}

TEST(ReadCalibration, TwoFilesMustBelongTogether) {
  EXPECT_THAT(mistake_in({written::kalibr(), infos(400, -48)[1]}), HasSubstr("tells both eyes"));
  EXPECT_THAT(mistake_in({infos(400, -48)[0], written::euroc(written::kRight, written::kLensRight,
                                                             cv::Matx44d::eye())}),
              HasSubstr("do not tell how the two cameras stand"));
}

}  // namespace
}  // namespace striate::datasets
