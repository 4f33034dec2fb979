#pragma once

#include <string>

#include "striate/app/perceive_options.hpp"
#include "striate/platform/datasets/calibration/camera_model.hpp"
#include "striate/platform/datasets/calibration/picture_rectifier.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::app {

/// A person's own camera, by its calibration: rectifies pictures, and says in the options what they
/// are then of.
class OwnCamera {
 public:
  OwnCamera(const datasets::StereoModel& model, cv::Size pictures, bool rectified)
      : rectifier_(model, pictures, rectified) {}

  void look(StereoFrame& frame, PerceiveOptions& options) const;
  [[nodiscard]] const datasets::PictureRectifier& rectifier() const { return rectifier_; }

 private:
  datasets::PictureRectifier rectifier_;
};

/// Says on standard error what the calibration is, what it lacks and what was assumed.
void tell_camera(const datasets::StereoModel& model, const datasets::PictureRectifier& to);

}  // namespace striate::app
