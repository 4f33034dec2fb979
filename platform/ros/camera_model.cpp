#include "striate/platform/ros/camera_model.hpp"

namespace striate::ros {

// P[3] is -focal times the place of the eye to the right of the first one; see the definition of P
// in sensor_msgs/CameraInfo.
double CameraModel::baseline_m() const {
  if (baseline_m_ > 0.0) return baseline_m_;
  if (!(right_.projection[0] > 0.0) || !(left_.projection[0] > 0.0)) return 0.0;
  return left_.projection[3] / left_.projection[0] - right_.projection[3] / right_.projection[0];
}

void CameraModel::fill(StereoFrame& frame) const {
  const double scale =
      left_.width_px > 0 ? static_cast<double>(frame.left.cols) / left_.width_px : 1.0;
  const bool has_centre = left_.projection[2] > 0.0 && left_.projection[6] > 0.0;
  frame.focal_px = focal_px_ > 0.0 ? focal_px_ : left_.projection[0] * scale;
  // Pixel centres are at integers here and there; a smaller image keeps its outer edges.
  frame.centre_u_px =
      has_centre ? (left_.projection[2] + 0.5) * scale - 0.5 : (frame.left.cols - 1) / 2.0;
  frame.centre_v_px =
      has_centre ? (left_.projection[6] + 0.5) * scale - 0.5 : (frame.left.rows - 1) / 2.0;
  frame.baseline_m = baseline_m();
}

}  // namespace striate::ros
