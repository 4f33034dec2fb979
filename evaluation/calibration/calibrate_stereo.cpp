#include "striate/evaluation/calibration/calibrate_stereo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/calib3d.hpp>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/calibration/consistent_pairs.hpp"

namespace striate::evaluation {
namespace {

/// Of 40 to 60 degrees: no third radial term; with it a few images give wild edges
constexpr int kLens = cv::CALIB_FIX_K3;

/// Times the middle error: a look that is worse was found or seen wrongly (by hand)
constexpr double kWorse = 4.0;

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

struct OneEye {
  pioneer::CameraModel camera;
  std::vector<double> errors_px;  ///< of every look
};

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

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double limit_of(const std::vector<double>& errors_px) {
  return std::max(pioneer::kPoor_px, kWorse * middle_of(errors_px));
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
  return kept.size() < kFewestPairs ? pairs : chosen(pairs, kept);
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

/// Index of the pair that is far worse than the others; as many as there are pairs: none is.
std::size_t far_worse(const std::vector<PairError>& pairs) {
  std::vector<double> errors_px;
  for (const PairError& pair : pairs) {
    errors_px.push_back(std::max(pair.reprojection_px, pair.epipolar_px));
  }
  const auto worst = std::ranges::max_element(errors_px);
  if (*worst <= limit_of(errors_px)) return pairs.size();
  return static_cast<std::size_t>(worst - errors_px.begin());
}

std::vector<PairError> left_out_of(const std::vector<BoardPair>& all,
                                   const CalibrationReport& report, const Chessboard& board) {
  std::vector<PairError> result;
  const Rectification rectified = rectification_of(report.calibration);
  for (const BoardPair& pair : all) {
    if (std::ranges::find(report.pairs, pair.name, &PairError::name) != report.pairs.end()) {
      continue;
    }
    const double squared = squared_heights(pair, report.calibration, rectified);
    result.push_back({pair.name, disagreement_px(pair, board, report.calibration),
                      std::sqrt(squared / static_cast<double>(pair.left_px.size()))});
  }
  std::ranges::sort(result, std::greater<>(), &PairError::reprojection_px);
  return result;
}

constexpr const char* kMoment =
    "\n  hint: both images of a pair must be taken at the same moment, of a board that does not "
    "move and lies flat on something stiff";

void check_agreeing(const std::vector<BoardPair>& kept, const std::vector<BoardPair>& all) {
  if (kept.size() >= kFewestPairs && 2 * kept.size() > all.size()) return;
  std::string others;
  for (const BoardPair& pair : all) {
    if (std::ranges::find(kept, pair.name, &BoardPair::name) != kept.end()) continue;
    others += (others.empty() ? "" : ", ") + pair.name;
  }
  throw UserError(
      fmt::format("of {} pairs no more than {} agree on how the two cameras stand to each other; "
                  "at least {} are needed, and more than half. These do not: {}{}",
                  all.size(), kept.size(), kFewestPairs, others, kMoment));
}

void check_exact(const CalibrationReport& report) {
  const double error = pioneer::error_px(report.calibration);
  if (pioneer::exactness_of(error) != pioneer::Exactness::useless) return;
  throw UserError(
      fmt::format("the calibration errs by {:.1f} px, with which no picture is matched rightly; up "
                  "to {:.0f} px "
                  "can be used, below 0.5 px is usual. The worst pairs: {}{}",
                  error, pioneer::kUseless_px, worst_of(report.pairs), kMoment));
}

void check_enough(const std::vector<BoardPair>& pairs) {
  if (pairs.size() >= kFewestPairs) return;
  throw UserError(
      fmt::format("{} pairs show the whole board in both images, {} are needed\n"
                  "  hint: 15 to 30, near and far, tilted, and in all corners of the image",
                  pairs.size(), kFewestPairs));
}

}  // namespace

std::string worst_of(std::vector<PairError> pairs) {
  constexpr std::size_t kNamed = 5;  // of a list that a person reads (by hand)
  std::ranges::sort(pairs, std::greater<>(), &PairError::reprojection_px);
  std::string text;
  for (std::size_t i = 0; i < std::min(kNamed, pairs.size()); ++i) {
    text += fmt::format("{}{} ({:.1f} px)", i == 0 ? "" : ", ", pairs[i].name,
                        pairs[i].reprojection_px);
  }
  if (pairs.size() > kNamed) text += fmt::format(" and {} more", pairs.size() - kNamed);
  return text;
}

CalibrationReport calibrate_stereo(const std::vector<BoardPair>& pairs, const Chessboard& board,
                                   cv::Size size_px) {
  check_enough(pairs);
  std::vector<BoardPair> kept = without_wrong_looks(pairs, board, size_px);
  std::vector<double> errors_px;
  const pioneer::StereoCalibration lenses = lenses_of(kept, board, size_px, errors_px);
  kept = chosen(kept, consistent_pairs(kept, board, lenses, middle_of(errors_px)));
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
