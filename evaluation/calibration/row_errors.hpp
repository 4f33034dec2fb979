#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "striate/evaluation/calibration/calibration_report.hpp"
#include "striate/evaluation/calibration/chessboard.hpp"

/// How far from one row the two eyes see a corner, after rectification.
namespace striate::evaluation {

struct Rectification {
  cv::Mat turn_left;
  cv::Mat turn_right;
  cv::Mat project_left;
  cv::Mat project_right;
};

[[nodiscard]] cv::Vec<double, 5> five(const cv::Mat& distortion);

[[nodiscard]] Rectification rectification_of(const pioneer::StereoCalibration& calibration);

[[nodiscard]] double squared_heights(const BoardPair& pair,
                                     const pioneer::StereoCalibration& calibration,
                                     const Rectification& rectified);

[[nodiscard]] double limit_of(const std::vector<double>& errors_px);

}  // namespace striate::evaluation
