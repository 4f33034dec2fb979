#include "striate/evaluation/calibration/calibrate_stereo.hpp"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "striate/base/user_error.hpp"

namespace striate::evaluation {
namespace {

/// Lenses of some 40 to 60 degrees need no third radial term; with it a few images give wild
/// edges.
/// Of 40 to 60 degrees: no third radial term; with it a few images give wild edges
constexpr int kLens = cv::CALIB_FIX_K3;

struct Corners {
  std::vector<std::vector<cv::Point3f>> board;
  std::vector<std::vector<cv::Point2f>> left;
  std::vector<std::vector<cv::Point2f>> right;
};

struct Rectification {
  cv::Mat turn_left;
  cv::Mat turn_right;
  cv::Mat project_left;
  cv::Mat project_right;
};

cv::Mat first_guess(const Corners& corners, const std::vector<std::vector<cv::Point2f>>& seen,
                    cv::Size size_px, cv::Mat& distortion) {
  cv::Mat matrix;
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> ways;
  cv::calibrateCamera(corners.board, seen, size_px, matrix, distortion, turns, ways, kLens);
  return matrix;
}

cv::Vec<double, 5> five(const cv::Mat& distortion) {
  cv::Vec<double, 5> result{};
  for (int i = 0; i < std::min<int>(5, static_cast<int>(distortion.total())); ++i) {
    result[i] = distortion.at<double>(i);
  }
  return result;
}

Rectification rectification_of(const pioneer::StereoCalibration& calibration) {
  Rectification result;
  cv::Mat to_depth;
  cv::stereoRectify(calibration.left.matrix, calibration.left.distortion, calibration.right.matrix,
                    calibration.right.distortion, calibration.size_px, calibration.rotation,
                    calibration.translation_m, result.turn_left, result.turn_right,
                    result.project_left, result.project_right, to_depth);
  return result;
}

double squared_heights(const BoardPair& pair, const pioneer::StereoCalibration& calibration,
                       const Rectification& rectified) {
  std::vector<cv::Point2f> left;
  std::vector<cv::Point2f> right;
  cv::undistortPoints(pair.left_px, left, calibration.left.matrix, calibration.left.distortion,
                      rectified.turn_left, rectified.project_left);
  cv::undistortPoints(pair.right_px, right, calibration.right.matrix, calibration.right.distortion,
                      rectified.turn_right, rectified.project_right);
  double sum = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    sum += std::pow(static_cast<double>(left[i].y) - static_cast<double>(right[i].y), 2);
  }
  return sum;
}

Corners gather(const std::vector<BoardPair>& pairs, const Chessboard& board) {
  Corners corners;
  for (const BoardPair& pair : pairs) {
    corners.board.push_back(corners_of(board));
    corners.left.push_back(pair.left_px);
    corners.right.push_back(pair.right_px);
  }
  return corners;
}

void check_enough(const std::vector<BoardPair>& pairs) {
  if (pairs.size() >= kFewestPairs) return;
  throw UserError(
      fmt::format("{} pairs show the whole board in both images, {} are needed\n"
                  "  hint: 15 to 30, near and far, tilted, and in all corners of the image",
                  pairs.size(), kFewestPairs));
}

}  // namespace

CalibrationReport calibrate_stereo(const std::vector<BoardPair>& pairs, const Chessboard& board,
                                   cv::Size size_px) {
  check_enough(pairs);
  const Corners corners = gather(pairs, board);
  cv::Mat left_lens;
  cv::Mat right_lens;
  cv::Mat left = first_guess(corners, corners.left, size_px, left_lens);
  cv::Mat right = first_guess(corners, corners.right, size_px, right_lens);
  cv::Mat turn;
  cv::Mat way;
  cv::Mat essential;
  cv::Mat fundamental;
  cv::Mat errors;
  CalibrationReport report;
  pioneer::StereoCalibration& found = report.calibration;
  found.reprojection_px = cv::stereoCalibrate(
      corners.board, corners.left, corners.right, left, left_lens, right, right_lens, size_px, turn,
      way, essential, fundamental, errors, cv::CALIB_USE_INTRINSIC_GUESS | kLens);
  found.size_px = size_px;
  found.pairs = static_cast<int>(pairs.size());
  found.left = {left, five(left_lens)};
  found.right = {right, five(right_lens)};
  found.rotation = turn;
  found.translation_m = way;
  if (found.translation_m[0] >= 0.0) {
    throw UserError("the right images were taken left of the left ones\n  hint: --swap");
  }
  const Rectification rectified = rectification_of(found);
  double sum = 0.0;
  double points = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double squared = squared_heights(pairs[i], found, rectified);
    const auto count = static_cast<double>(pairs[i].left_px.size());
    sum += squared;
    points += count;
    const int row = static_cast<int>(i);
    const double both = std::hypot(errors.at<double>(row, 0), errors.at<double>(row, 1));
    report.pairs.push_back({pairs[i].name, both / std::sqrt(2.0), std::sqrt(squared / count)});
  }
  found.epipolar_px = std::sqrt(sum / points);
  return report;
}

}  // namespace striate::evaluation
