#pragma once

#include <string>

#include "striate/base/pioneer_devices.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::pioneer {

/// Of cameras that are read here. An image stream brings its own numbers and needs only the mount;
/// `field` and `baseline` are then what its numbers are checked against.
struct StereoCameraSettings {
  double height_m = RobotDescription{}.camera_height_m;
  double forward_m = RobotDescription{}.camera_forward_m;
  double resting_tilt_rad = RobotDescription{}.resting_tilt_rad;
  std::string calibration;
  bool swap = false;
  int width_px = 320;  ///< twice the stereo's working width of 160
  /// Half of the longest shutter (33 ms) and an image's transfer at 20 Hz (ours)
  double latency_s = 0.05;
  double field_rad =
      RobotDescription{}.view_rad;   ///< Bumblebee-2: 6 mm lens, 1024 pixels of 4.65 um
  double baseline_m = kEyesApart_m;  ///< Bumblebee-2's; paper
};

template <class V>
void visit(V& v, StereoCameraSettings& s) {
  using config::Unit;
  v.number("height", s.height_m, Unit::length, {0.1, 2.5}, "of the cameras above the floor");
  v.number("forward", s.forward_m, Unit::length, {-0.5, 0.5}, "of the pan axis before the axle");
  v.number("resting_tilt", s.resting_tilt_rad, Unit::angle, {-0.6, 0.6},
           "of the head while nothing else is wanted, up positive");
  v.text("calibration", s.calibration,
         "file of 'striate calibrate'; without it the images must be rectified already");
  v.flag("swap", s.swap, "the camera gives right and left the other way round");
  v.integer("width", s.width_px, {32, 1280}, "pixels a line of what the vision gets");
  v.number("latency", s.latency_s, Unit::duration, {0.0, 2.0}, "from light to image");
  v.number("field", s.field_rad, Unit::angle, {radians(10), radians(120)},
           "horizontal view, where there is no calibration; a stream must say about the same");
  v.number("baseline", s.baseline_m, Unit::length, {0.01, 1.0},
           "between the eyes, where there is no calibration; a stream must say about the same");
}

}  // namespace striate::pioneer
