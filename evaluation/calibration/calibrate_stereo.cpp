#include "striate/evaluation/calibration/calibrate_stereo.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "striate/base/median.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/calibration/calibration_checks.hpp"
#include "striate/evaluation/calibration/consistent_pairs.hpp"
#include "striate/evaluation/calibration/row_errors.hpp"

namespace striate::evaluation {
namespace {

/// Of 40 to 60 degrees: no third radial term; with it a few images give wild edges
constexpr int kLens = cv::CALIB_FIX_K3;

struct Corners {
  std::vector<std::vector<cv::Point3f>> board;
  std::vector<std::vector<cv::Point2f>> left;
  std::vector<std::vector<cv::Point2f>> right;
};

struct OneEye {
  pioneer::CameraModel camera;
  std::vector<double> errors_px;  ///< of every look
};

Corners gather(const std::vector<BoardPair>& pairs, const Chessboard& board) {
  Corners corners;
  for (const BoardPair& pair : pairs) {
    corners.board.push_back(corners_of(board));
    corners.left.push_back(pair.left_px);
    corners.right.push_back(pair.right_px);
  }
  return corners;
}

OneEye calibrate_alone(const Corners& corners, const std::vector<std::vector<cv::Point2f>>& seen,
                       cv::Size size_px) {
  cv::Mat matrix;
  cv::Mat distortion;
  cv::Mat errors;
  cv::calibrateCamera(corners.board, seen, size_px, matrix, distortion, cv::noArray(),
                      cv::noArray(), cv::noArray(), cv::noArray(), errors, kLens);
  OneEye eye{{matrix, five(distortion)}, {}};
  for (int i = 0; i < static_cast<int>(errors.total()); ++i) {
    eye.errors_px.push_back(errors.at<double>(i));
  }
  return eye;
}

pioneer::StereoCalibration lenses_of(const std::vector<BoardPair>& pairs, const Chessboard& board,
                                     cv::Size size_px, std::vector<double>& worse_px) {
  const Corners corners = gather(pairs, board);
  const OneEye left = calibrate_alone(corners, corners.left, size_px);
  const OneEye right = calibrate_alone(corners, corners.right, size_px);
  worse_px.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    worse_px.push_back(std::max(left.errors_px[i], right.errors_px[i]));
  }
  pioneer::StereoCalibration lenses;
  lenses.size_px = size_px;
  lenses.left = left.camera;
  lenses.right = right.camera;
  return lenses;
}

std::vector<BoardPair> chosen(const std::vector<BoardPair>& pairs,
                              const std::vector<std::size_t>& which) {
  std::vector<BoardPair> result;
  for (const std::size_t i : which) result.push_back(pairs[i]);
  return result;
}

/// Looks in which the corners of one eye alone fit no lens.
std::vector<BoardPair> without_wrong_looks(const std::vector<BoardPair>& pairs,
                                           const Chessboard& board, cv::Size size_px) {
  std::vector<double> worse_px;
  (void)lenses_of(pairs, board, size_px, worse_px);
  const double limit_px = limit_of(worse_px);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (worse_px[i] <= limit_px) kept.push_back(i);
  }
  return kept.size() < kFewestBoardPairs ? pairs : chosen(pairs, kept);
}

/// Both eyes together, from these pairs.
CalibrationReport calibrate_together(const std::vector<BoardPair>& pairs, const Chessboard& board,
                                     const pioneer::StereoCalibration& lenses) {
  const Corners corners = gather(pairs, board);
  cv::Mat left(lenses.left.matrix), left_lens(lenses.left.distortion);
  cv::Mat right(lenses.right.matrix), right_lens(lenses.right.distortion);
  cv::Mat turn;
  cv::Mat way;
  cv::Mat errors;
  CalibrationReport report;
  pioneer::StereoCalibration& found = report.calibration;
  found.reprojection_px =
      cv::stereoCalibrate(corners.board, corners.left, corners.right, left, left_lens, right,
                          right_lens, lenses.size_px, turn, way, cv::noArray(), cv::noArray(),
                          errors, cv::CALIB_USE_INTRINSIC_GUESS | kLens);
  found.size_px = lenses.size_px;
  found.pairs = static_cast<int>(pairs.size());
  found.left = {left, five(left_lens)};
  found.right = {right, five(right_lens)};
  found.rotation = turn;
  found.translation_m = way;
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

}  // namespace

CalibrationReport calibrate_stereo(const std::vector<BoardPair>& pairs, const Chessboard& board,
                                   cv::Size size_px) {
  check_enough(pairs);
  std::vector<BoardPair> kept = without_wrong_looks(pairs, board, size_px);
  std::vector<double> errors_px;
  const pioneer::StereoCalibration lenses = lenses_of(kept, board, size_px, errors_px);
  kept = chosen(kept, consistent_pairs(kept, board, lenses, median_of(errors_px)));
  check_agreeing(kept, pairs);
  CalibrationReport report = calibrate_together(kept, board, lenses);
  for (std::size_t worst = far_worse(report.pairs); worst < kept.size();
       worst = far_worse(report.pairs)) {
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(worst));
    check_agreeing(kept, pairs);
    report = calibrate_together(kept, board, lenses);
  }
  if (report.calibration.translation_m[0] >= 0.0) {
    throw UserError("the right images were taken left of the left ones\n  hint: --swap");
  }
  check_exact(report);
  report.left_out = left_out_of(pairs, report, board);
  return report;
}

}  // namespace striate::evaluation
