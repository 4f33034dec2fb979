#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <opencv2/imgproc.hpp>

#include "striate/base/geometry.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/calibration/board_images.hpp"
#include "striate/evaluation/calibration/calibrate_stereo.hpp"
#include "striate/platform/pioneer/camera/rectifier.hpp"
#include "tests/reference/board_camera.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::evaluation {
namespace {

using reference::BoardCamera;

constexpr Chessboard kBoard{8, 5, 0.04};
const cv::Size kPhoto_px(480, 360);

/// Two lenses that bulge, of slightly different length, slightly turned against each other.
pioneer::StereoCalibration true_cameras() {
  pioneer::StereoCalibration truth;
  truth.size_px = kPhoto_px;
  truth.left.matrix = {610.0, 0.0, 236.0, 0.0, 608.0, 183.0, 0.0, 0.0, 1.0};
  truth.left.distortion = {-0.18, 0.12, 0.0, 0.0, 0.0};
  truth.right.matrix = {604.0, 0.0, 245.0, 0.0, 603.0, 176.0, 0.0, 0.0, 1.0};
  truth.right.distortion = {-0.16, 0.10, 0.0, 0.0, 0.0};
  cv::Mat turn;
  cv::Rodrigues(cv::Vec3d(0.012, -0.02, 0.008), turn);
  truth.rotation = turn;
  truth.translation_m = {-0.1203, 0.0011, -0.0007};
  return truth;
}

struct Images {
  std::vector<cv::Mat1b> left;
  std::vector<cv::Mat1b> right;
};

/// Boards near and far, turned, and in all corners.
const Images& boards() {
  static const Images pictures = [] {
    const pioneer::StereoCalibration truth = true_cameras();
    const BoardCamera left(truth.left, kPhoto_px);
    const BoardCamera right(truth.right, kPhoto_px);
    Images result;
    for (int i = 0; i < 14; ++i) {
      const double z_m = 0.85 + 0.1 * (i % 4);
      const cv::Vec3d tilt(0.5 * std::sin(1.3 * i), 0.5 * std::cos(1.7 * i),
                           0.15 * std::sin(2.1 * i));
      cv::Mat rotated;
      cv::Rodrigues(tilt, rotated);
      const cv::Matx33d turn = rotated;
      const cv::Vec3d middle(0.04 + 0.08 * std::sin(2.0 * i), 0.06 * std::cos(2.6 * i), z_m);
      const cv::Vec3d way = middle - turn * cv::Vec3d(3.5 * 0.04, 2.0 * 0.04, 0.0);
      result.left.push_back(left.image(8, 5, 0.04, turn, way));
      result.right.push_back(right.image(8, 5, 0.04, truth.rotation * turn,
                                         truth.rotation * way + truth.translation_m));
    }
    return result;
  }();
  return pictures;
}

const std::vector<BoardPair>& found() {
  static const std::vector<BoardPair> pairs = [] {
    std::vector<BoardPair> result;
    for (std::size_t i = 0; i < boards().left.size(); ++i) {
      if (auto pair = find_board(boards().left[i], boards().right[i], kBoard)) {
        result.push_back(std::move(*pair));
      }
    }
    return result;
  }();
  return pairs;
}

TEST(CalibrateStereo, FindsTheCamerasThatDrewTheBoards) {
  const auto& pairs = found();
  ASSERT_GE(pairs.size(), 12u);
  const CalibrationReport report = calibrate_stereo(pairs, kBoard, kPhoto_px);
  const pioneer::StereoCalibration& calibration = report.calibration;
  const pioneer::StereoCalibration truth = true_cameras();
  RecordProperty("reprojection_px", std::to_string(calibration.reprojection_px));
  RecordProperty("epipolar_px", std::to_string(calibration.epipolar_px));
  EXPECT_LT(calibration.reprojection_px, 0.1);
  EXPECT_LT(calibration.epipolar_px, 0.1);
  EXPECT_NEAR(calibration.left.matrix(0, 0), truth.left.matrix(0, 0), 6.0);
  EXPECT_NEAR(calibration.right.matrix(1, 1), truth.right.matrix(1, 1), 6.0);
  EXPECT_NEAR(calibration.left.matrix(0, 2), truth.left.matrix(0, 2), 3.0);
  EXPECT_NEAR(calibration.left.distortion[0], truth.left.distortion[0], 0.03);
  EXPECT_NEAR(calibration.translation_m[0], truth.translation_m[0], 0.0006);
  EXPECT_LT(cv::norm(calibration.rotation - truth.rotation), 0.006);
  ASSERT_EQ(report.pairs.size(), pairs.size());
  EXPECT_LT(report.pairs.front().reprojection_px, 0.2);
}

TEST(CalibrateStereo, ItsFileRectifiesTheImagesItWasMadeFrom) {
  const reference::TemporaryFolder folder;
  const std::string file = folder / "stereo.yaml";
  pioneer::write_calibration(file, calibrate_stereo(found(), kBoard, kPhoto_px).calibration);
  pioneer::Rectifier rectifier(pioneer::read_calibration(file), kPhoto_px.width);
  int compared = 0;
  for (std::size_t i = 0; i < boards().left.size(); ++i) {
    cv::Mat3b left;
    cv::Mat3b right;
    cv::cvtColor(boards().left[i], left, cv::COLOR_GRAY2BGR);
    cv::cvtColor(boards().right[i], right, cv::COLOR_GRAY2BGR);
    StereoFrame frame;
    rectifier.rectify(left, right, frame);
    EXPECT_NEAR(frame.baseline_m, 0.1203, 0.0006);
    cv::Mat1b grey_left;
    cv::Mat1b grey_right;
    cv::cvtColor(frame.left, grey_left, cv::COLOR_BGR2GRAY);
    cv::cvtColor(frame.right, grey_right, cv::COLOR_BGR2GRAY);
    const auto pair = find_board(grey_left, grey_right, kBoard);
    if (!pair) continue;  // a part of it lies beyond the border now
    ++compared;
    double squared = 0.0;
    std::vector<cv::Point3d> seen;
    for (std::size_t k = 0; k < pair->left_px.size(); ++k) {
      const cv::Point2d l = pair->left_px[k];
      const cv::Point2d r = pair->right_px[k];
      squared += (l.y - r.y) * (l.y - r.y);
      const double z_m = frame.focal_px * frame.baseline_m / (l.x - r.x);
      seen.emplace_back((l.x - frame.centre_u_px) * z_m / frame.focal_px,
                        (l.y - frame.centre_v_px) * z_m / frame.focal_px, z_m);
    }
    EXPECT_LT(std::sqrt(squared / static_cast<double>(seen.size())), 0.15);
    EXPECT_NEAR(cv::norm(seen.front() - seen.back()), 0.04 * std::hypot(7.0, 4.0), 0.006)
        << "the board is as large as it is";
  }
  EXPECT_GE(compared, 6);
}

std::vector<BoardPair> named_pairs() {
  std::vector<BoardPair> pairs = found();
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].name = "p" + std::to_string(i);
  return pairs;
}

/// The board has moved on when the right image is taken.
void take_right_from(std::vector<BoardPair>& pairs, std::size_t which, std::size_t other) {
  pairs[which].right_px = found()[other].right_px;
}

TEST(CalibrateStereo, PairsThatWereNotTakenAtOneMomentAreNamedAndSpoilNothing) {
  const double baseline_m = cv::norm(true_cameras().translation_m);
  for (const std::vector<std::size_t>& wrong : {std::vector<std::size_t>{4}, {0}, {2, 7, 9, 11}}) {
    std::vector<BoardPair> pairs = named_pairs();
    for (const std::size_t i : wrong) take_right_from(pairs, i, (i + 1) % pairs.size());
    const CalibrationReport report = calibrate_stereo(pairs, kBoard, kPhoto_px);
    EXPECT_LT(report.calibration.reprojection_px, 0.15);
    EXPECT_NEAR(cv::norm(report.calibration.translation_m), baseline_m, 0.001);
    std::vector<std::string> left_out;
    for (const PairError& pair : report.left_out) {
      left_out.push_back(pair.name);
      EXPECT_GT(pair.reprojection_px, 3.0);
    }
    std::vector<std::string> expected;
    for (const std::size_t i : wrong) expected.push_back("p" + std::to_string(i));
    EXPECT_THAT(left_out, testing::UnorderedElementsAreArray(expected));
    EXPECT_EQ(report.pairs.size() + wrong.size(), pairs.size());
  }
}

TEST(CalibrateStereo, ABoardThatSlippedALittleIsLeftOutToo) {
  std::vector<BoardPair> pairs = named_pairs();
  for (cv::Point2f& corner : pairs[3].right_px) corner += cv::Point2f(0.0F, 2.5F);
  const CalibrationReport report = calibrate_stereo(pairs, kBoard, kPhoto_px);
  ASSERT_EQ(report.left_out.size(), 1U);
  EXPECT_EQ(report.left_out.front().name, "p3");
  EXPECT_LT(report.calibration.epipolar_px, 0.15);
}

TEST(CalibrateStereo, CornersOfOneEyeThatFitNoLensAreLeftOut) {
  std::vector<BoardPair> pairs = named_pairs();
  for (std::size_t k = 0; k < 8; ++k) pairs[6].left_px[k] += cv::Point2f(9.0F, -7.0F);
  const CalibrationReport report = calibrate_stereo(pairs, kBoard, kPhoto_px);
  ASSERT_EQ(report.left_out.size(), 1U);
  EXPECT_EQ(report.left_out.front().name, "p6");
  EXPECT_NEAR(report.calibration.left.matrix(0, 0), 610.0, 6.0);
}

TEST(CalibrateStereo, WhereAllRightImagesCameLateNothingIsMadeOfThem) {
  std::vector<BoardPair> pairs = named_pairs();
  for (std::size_t i = 0; i < pairs.size(); ++i) take_right_from(pairs, i, (i + 1) % pairs.size());
  try {
    (void)calibrate_stereo(pairs, kBoard, kPhoto_px);
    ADD_FAILURE() << "late images were not noticed";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("same moment"));
  }
}

TEST(CalibrateStereo, WhereTooFewAgreeThoseThatDoNotAreNamed) {
  std::vector<BoardPair> pairs = named_pairs();
  pairs.resize(5);
  take_right_from(pairs, 2, 3);
  try {
    (void)calibrate_stereo(pairs, kBoard, kPhoto_px);
    ADD_FAILURE() << "four pairs were enough";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("These do not: p2"));
  }
}

/// Corners of every image, found so badly.
std::vector<BoardPair> blurred_pairs(double by_px) {
  std::vector<BoardPair> pairs = named_pairs();
  cv::RNG random(5);
  for (BoardPair& pair : pairs) {
    for (std::vector<cv::Point2f>* corners : {&pair.left_px, &pair.right_px}) {
      for (cv::Point2f& corner : *corners) {
        corner += cv::Point2f(static_cast<float>(random.gaussian(by_px)),
                              static_cast<float>(random.gaussian(by_px)));
      }
    }
  }
  return pairs;
}

TEST(CalibrateStereo, CornersThatErrByAPixelMakeAPoorOneAndByFiveNone) {
  const CalibrationReport report = calibrate_stereo(blurred_pairs(1.0), kBoard, kPhoto_px);
  EXPECT_EQ(pioneer::exactness_of(report.calibration), pioneer::Exactness::poor)
      << pioneer::error_px(report.calibration);
  EXPECT_THAT(worst_of(report.pairs), testing::ContainsRegex("p[0-9]+ \\([0-9.]+ px\\), p"));
  try {
    (void)calibrate_stereo(blurred_pairs(5.0), kBoard, kPhoto_px);
    ADD_FAILURE() << "a calibration with which nothing can be matched";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("moment"));
  }
}

TEST(StereoCalibration, IsJudgedByTheErrorsThatStandInIt) {
  const reference::TemporaryFolder folder;
  const std::string file = folder / "stereo.yaml";
  pioneer::StereoCalibration calibration = true_cameras();
  struct Judged {
    double reprojection_px, epipolar_px;
    pioneer::Exactness exactness;
  };
  for (const Judged& one : {Judged{0.2, 0.3, pioneer::Exactness::good},
                            {1.2, 0.3, pioneer::Exactness::poor},
                            {0.3, 2.9, pioneer::Exactness::poor},
                            {42.0, 0.4, pioneer::Exactness::useless},
                            {0.2, std::nan(""), pioneer::Exactness::useless},
                            {0.0, 0.0, pioneer::Exactness::unknown}}) {
    calibration.reprojection_px = one.reprojection_px;
    calibration.epipolar_px = one.epipolar_px;
    EXPECT_EQ(pioneer::exactness_of(calibration), one.exactness) << one.reprojection_px;
    pioneer::write_calibration(file, calibration);
    if (one.exactness == pioneer::Exactness::useless) {
      EXPECT_THROW((void)pioneer::usable_calibration(file), UserError);
    } else {
      EXPECT_NO_THROW((void)pioneer::usable_calibration(file));
    }
  }
}

TEST(CalibrateStereo, TellsWhatIsMissing) {
  std::vector<BoardPair> pairs = found();
  std::vector<BoardPair> few(pairs.begin(), pairs.begin() + 3);
  EXPECT_THROW((void)calibrate_stereo(few, kBoard, kPhoto_px), UserError);
  for (BoardPair& pair : pairs) std::swap(pair.left_px, pair.right_px);
  try {
    (void)calibrate_stereo(pairs, kBoard, kPhoto_px);
    ADD_FAILURE() << "exchanged eyes were not noticed";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("--swap"));
  }
}

TEST(StereoCalibration, AFileThatIsNoneIsRefused) {
  const reference::TemporaryFolder folder;
  const std::string file = folder / "no.yaml";
  std::ofstream(file) << "%YAML:1.0\n---\nimage_width: 320\n";
  EXPECT_THROW((void)pioneer::read_calibration(file), UserError);
  EXPECT_THROW((void)pioneer::read_calibration(folder / "missing.yaml"), UserError);
}

}  // namespace
}  // namespace striate::evaluation
