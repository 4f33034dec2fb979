#include "striate/platform/remote/camera_model.hpp"

#include "striate/platform/interface/align_eyes.hpp"

namespace striate::remote {

// P[3] is -focal times the place of the eye to the right of the first one; see the definition of P
// in sensor_msgs/CameraInfo.
double CameraModel::baseline_m() const {
  if (baseline_m_ > 0.0) return baseline_m_;
  if (!(right_.projection[0] > 0.0) || !(left_.projection[0] > 0.0)) return 0.0;
  return left_.projection[3] / left_.projection[0] - right_.projection[3] / right_.projection[0];
}

void CameraModel::fill(StereoFrame& frame) const {
  const auto scale_of = [&frame](const EyeInfo& eye) {
    return eye.width_px > 0 ? static_cast<double>(frame.left.cols) / eye.width_px : 1.0;
  };
  const auto has_centre = [](const EyeInfo& eye) {
    return eye.projection[2] > 0.0 && eye.projection[6] > 0.0;
  };
  // Pixel centres are at integers here and there; a smaller image keeps its outer edges.
  const auto centre = [](double px, double scale) { return (px + 0.5) * scale - 0.5; };
  const double scale = scale_of(left_);
  frame.focal_px = focal_px_ > 0.0 ? focal_px_ : left_.projection[0] * scale;
  frame.centre_u_px =
      has_centre(left_) ? centre(left_.projection[2], scale) : (frame.left.cols - 1) / 2.0;
  frame.centre_v_px =
      has_centre(left_) ? centre(left_.projection[6], scale) : (frame.left.rows - 1) / 2.0;
  frame.baseline_m = baseline_m();
  if (!has_centre(left_) || !has_centre(right_)) return;
  const double right_scale = scale_of(right_);
  // A focal length that was told by hand is that of both eyes.
  const double right_focal_px =
      focal_px_ > 0.0 ? frame.focal_px : right_.projection[0] * right_scale;
  align_eyes(frame, {right_focal_px, centre(right_.projection[2], right_scale),
                     centre(right_.projection[6], right_scale)});
}

}  // namespace striate::remote
