#pragma once

#include <array>

#include "striate/platform/interface/senses.hpp"

namespace striate::remote {

/// What of sensor_msgs/CameraInfo a rectified image needs.
struct EyeInfo {
  int width_px = 0;                     ///< of the image that was calibrated; 0: unknown
  std::array<double, 12> projection{};  ///< P, row by row, of the rectified camera
};

/// Focal length, principal point and distance of two eyes from their CameraInfo.
class CameraModel {
 public:
  /// Values above zero count before what CameraInfo says.
  CameraModel(double focal_px, double baseline_m) : focal_px_(focal_px), baseline_m_(baseline_m) {}

  void set_left(const EyeInfo& info) { left_ = info; }
  void set_right(const EyeInfo& info) { right_ = info; }
  [[nodiscard]] bool known() const { return focal_px() > 0.0 && baseline_m() > 0.0; }
  /// The right eye stands to the left of the left one: topics are swapped.
  [[nodiscard]] bool swapped() const { return baseline_m() < 0.0; }
  /// Fills all of `frame` that the images in it do not say. They may be smaller than calibrated.
  /// Where the two P matrices differ in principal point or focal length, the right image is moved.
  void fill(StereoFrame& frame) const;

 private:
  [[nodiscard]] double focal_px() const {
    return focal_px_ > 0.0 ? focal_px_ : left_.projection[0];
  }
  [[nodiscard]] double baseline_m() const;

  double focal_px_;
  double baseline_m_;
  EyeInfo left_;
  EyeInfo right_;
};

}  // namespace striate::remote
