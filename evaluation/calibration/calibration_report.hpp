#pragma once

#include <string>
#include <vector>

#include "striate/platform/pioneer/camera/stereo_calibration.hpp"

namespace striate::evaluation {

/// With fewer the lens and the eyes' turn cannot be told apart (ours)
inline constexpr std::size_t kFewestBoardPairs = 5;

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

/// Names and errors of the worst few, worst first, for a sentence.
[[nodiscard]] std::string worst_of(std::vector<PairError> pairs);

}  // namespace striate::evaluation
