#pragma once

#include "striate/evaluation/calibration/chessboard.hpp"
#include "striate/platform/pioneer/camera/stereo_calibration.hpp"

namespace striate::evaluation {

/// With fewer the lens and the eyes' turn cannot be told apart (ours)
inline constexpr std::size_t kFewestPairs = 5;

/// How well one pair agrees with the calibration.
struct PairError {
  std::string name;
  double reprojection_px = 0.0;  ///< root mean square over both cameras
  double epipolar_px = 0.0;      ///< root mean square height between matching corners, rectified
};

struct CalibrationReport {
  pioneer::StereoCalibration calibration;
  std::vector<PairError> pairs;     ///< that it was made from
  std::vector<PairError> left_out;  ///< that do not agree with the others, worst first
};

/// Lenses and pose of two cameras from looks at a chessboard: each camera alone, then both
/// together, from the pairs that agree with each other (see consistent_pairs.hpp).
/// @param size_px of the images
/// @throws UserError with fewer than kFewestPairs pairs or fewer that agree, where right and left
/// are exchanged, and where the error is above pioneer::kUseless_px; it names the worst pairs.
[[nodiscard]] CalibrationReport calibrate_stereo(const std::vector<BoardPair>& pairs,
                                                 const Chessboard& board, cv::Size size_px);

/// Names and errors of the worst few, worst first, for a sentence.
[[nodiscard]] std::string worst_of(std::vector<PairError> pairs);

}  // namespace striate::evaluation
