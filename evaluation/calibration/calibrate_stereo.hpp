#pragma once

#include "striate/evaluation/calibration/calibration_report.hpp"
#include "striate/evaluation/calibration/chessboard.hpp"

namespace striate::evaluation {

/// Lenses and pose of two cameras from looks at a chessboard: each camera alone, then both
/// together, from the pairs that agree with each other (see consistent_pairs.hpp).
/// @param size_px of the images
/// @throws UserError with fewer than kFewestBoardPairs pairs or fewer that agree, where right and
/// left are exchanged, and where the error is above pioneer::kUseless_px; it names the worst pairs.
[[nodiscard]] CalibrationReport calibrate_stereo(const std::vector<BoardPair>& pairs,
                                                 const Chessboard& board, cv::Size size_px);

}  // namespace striate::evaluation
