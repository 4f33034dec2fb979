#include "striate/evaluation/calibration/row_errors.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "striate/base/median.hpp"

namespace striate::evaluation {
namespace {

/// Times the middle error: a look that is worse was found or seen wrongly (by hand)
constexpr double kWorse = 4.0;

}  // namespace

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

double limit_of(const std::vector<double>& errors_px) {
  return std::max(pioneer::kPoor_px, kWorse * median_of(errors_px));
}

}  // namespace striate::evaluation
