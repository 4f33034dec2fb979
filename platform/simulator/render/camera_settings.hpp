#pragma once

#include "striate/base/geometry.hpp"
#include "striate/base/pioneer_devices.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::simulator {

/// The stereo head: optics, sensor and exposure control. Defaults: a small machine-vision pair
/// behind 43 degree lenses, rectified.
struct CameraSettings {
  int width_px = 320;  ///< the image is 4:3; twice the stereo's working width
  double field_rad = RobotDescription{}.view_rad;  ///< horizontal view of the paper's Bumblebee-2
  double baseline_m = kEyesApart_m;                ///< of the paper's Bumblebee-2
  double height_above_floor_m = RobotDescription{}.camera_height_m;
  double forward_of_axle_m = RobotDescription{}.camera_forward_m;
  double resting_tilt_rad = RobotDescription{}.resting_tilt_rad;

  double gain_mismatch = 0.01;     ///< between left and right
  double rectification_px = 0.15;  ///< vertical error that is left, root mean square
  double max_shutter_s = 0.033;    ///< a frame at 30 Hz; real stereo heads
  double max_gain = 16.0;          ///< 24 dB, as real stereo heads have
  double full_well_e = 13000.0;    ///< electrons of a saturated pixel at gain 1
  double read_noise_e = 9.0;       ///< electrons; as real stereo heads have
  double non_uniformity = 0.008;   ///< of the pixels' sensitivity
  double vignetting = 0.28;        ///< loss at the corner
  double target_level = 0.17;      ///< mean of the image, of full scale, that exposure seeks
  double adaptation = 0.5;         ///< share of the way to the right exposure, each image
  double flicker = 0.01;           ///< of the lamps, root mean square
  bool smooth_edges = true;        ///< three samples a pixel along edges
  bool noise = true;               ///< shot and read noise, unevenness of the pixels

  [[nodiscard]] int height_px() const { return width_px * 3 / 4; }
};

template <class V>
void visit(V& v, CameraSettings& s) {
  using config::Unit;
  v.integer("width", s.width_px, {32, 1280}, "pixels a line; the height is three quarters of it");
  v.number("field", s.field_rad, Unit::angle, {radians(10), radians(120)}, "horizontal view");
  v.number("baseline", s.baseline_m, Unit::length, {0.01, 1.0}, "between left and right camera");
  v.number("height", s.height_above_floor_m, Unit::length, {0.1, 2.5},
           "of the cameras above the floor");
  v.number("forward", s.forward_of_axle_m, Unit::length, {-0.5, 0.5},
           "of the pan axis before the axle");
  v.number("resting_tilt", s.resting_tilt_rad, Unit::angle, {-0.6, 0.6},
           "of the head while nothing else is wanted, up positive");
  v.number("gain_mismatch", s.gain_mismatch, Unit::fraction, {0, 0.3},
           "brightness of left against right");
  v.number("rectification", s.rectification_px, Unit::pixels, {0, 5},
           "vertical error left after rectifying");
  v.number("max_shutter", s.max_shutter_s, Unit::duration, {0.0001, 0.2},
           "longest exposure; then the gain rises");
  v.number("max_gain", s.max_gain, Unit::none, {1, 64}, "largest amplification");
  v.number("full_well", s.full_well_e, Unit::none, {100, 200000}, "electrons that a pixel holds");
  v.number("read_noise", s.read_noise_e, Unit::none, {0, 200}, "electrons, root mean square");
  v.number("non_uniformity", s.non_uniformity, Unit::fraction, {0, 0.2},
           "spread of the pixels' sensitivity");
  v.number("vignetting", s.vignetting, Unit::fraction, {0, 0.9}, "loss of light at the corner");
  v.number("target_level", s.target_level, Unit::fraction, {0.01, 0.9},
           "mean brightness that exposure seeks");
  v.number("adaptation", s.adaptation, Unit::fraction, {0.01, 1},
           "how fast exposure follows, an image");
  v.number("flicker", s.flicker, Unit::fraction, {0, 0.5}, "of the lamps");
  v.flag("smooth_edges", s.smooth_edges, "three samples a pixel along edges");
  v.flag("noise", s.noise, "shot noise, read noise, uneven pixels");
}

}  // namespace striate::simulator
