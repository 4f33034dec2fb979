#pragma once

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/pioneer/camera/stereo_calibration.hpp"

namespace striate::pioneer {

/// Makes pairs as two ideal cameras side by side would have taken them: no distortion, matching
/// points on the same line. Keeps its tables and buffers.
class Rectifier {
 public:
  /// @param width_px of the images that come out; they keep their shape.
  /// @throws UserError when the right camera stands left of the left one.
  Rectifier(const StereoCalibration& calibration, int width_px);

  /// The images and the camera's numbers of `frame`; the rest of it is left for the caller.
  /// @throws UserError when the images have not the size that the calibration is for.
  void rectify(const cv::Mat3b& left, const cv::Mat3b& right, StereoFrame& frame);

 private:
  struct Eye {
    cv::Mat map_1;
    cv::Mat map_2;
    cv::Mat3b small;
  };
  void rectify(const cv::Mat3b& raw, Eye& eye, cv::Mat3b& result) const;

  cv::Size raw_px_;
  cv::Size size_px_;
  Eye left_;
  Eye right_;
  double focal_px_ = 0.0;
  double centre_u_px_ = 0.0;
  double centre_v_px_ = 0.0;
  double baseline_m_ = 0.0;
};

}  // namespace striate::pioneer
