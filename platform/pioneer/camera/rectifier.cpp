#include "striate/platform/pioneer/camera/rectifier.hpp"

#include <fmt/format.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"

namespace striate::pioneer {

Rectifier::Rectifier(const StereoCalibration& calibration, int width_px)
    : raw_px_(calibration.size_px) {
  const StereoCalibration small = scaled(calibration, width_px);
  size_px_ = small.size_px;
  if (small.translation_m[0] >= 0.0) {
    throw UserError(
        "the calibration's right camera stands left of the left one\n"
        "  hint: 'swap: yes', here and for 'striate calibrate'");
  }
  cv::Mat turn_left;
  cv::Mat turn_right;
  cv::Mat project_left;
  cv::Mat project_right;
  cv::Mat to_depth;
  // Only what both cameras see in full is kept: the vision takes every pixel for one that was seen.
  constexpr double kNoBlackBorder = 0.0;
  cv::stereoRectify(small.left.matrix, small.left.distortion, small.right.matrix,
                    small.right.distortion, size_px_, small.rotation, small.translation_m,
                    turn_left, turn_right, project_left, project_right, to_depth,
                    cv::CALIB_ZERO_DISPARITY, kNoBlackBorder, size_px_);
  cv::initUndistortRectifyMap(small.left.matrix, small.left.distortion, turn_left, project_left,
                              size_px_, CV_16SC2, left_.map_1, left_.map_2);
  cv::initUndistortRectifyMap(small.right.matrix, small.right.distortion, turn_right, project_right,
                              size_px_, CV_16SC2, right_.map_1, right_.map_2);
  focal_px_ = project_left.at<double>(0, 0);
  centre_u_px_ = project_left.at<double>(0, 2);
  centre_v_px_ = project_left.at<double>(1, 2);
  baseline_m_ = cv::norm(small.translation_m);
}

void Rectifier::rectify(const cv::Mat3b& raw, Eye& eye, cv::Mat3b& result) const {
  if (raw.size() != raw_px_) {
    throw UserError(
        fmt::format("the camera's images are {} x {} px, its calibration is for {} x {}", raw.cols,
                    raw.rows, raw_px_.width, raw_px_.height));
  }
  const bool smaller = size_px_ != raw_px_;
  if (smaller) cv::resize(raw, eye.small, size_px_, 0.0, 0.0, cv::INTER_AREA);
  cv::remap(smaller ? eye.small : raw, result, eye.map_1, eye.map_2, cv::INTER_LINEAR);
}

void Rectifier::rectify(const cv::Mat3b& left, const cv::Mat3b& right, StereoFrame& frame) {
  rectify(left, left_, frame.left);
  rectify(right, right_, frame.right);
  frame.focal_px = focal_px_;
  frame.centre_u_px = centre_u_px_;
  frame.centre_v_px = centre_v_px_;
  frame.baseline_m = baseline_m_;
}

}  // namespace striate::pioneer
