#pragma once

#include "striate/base/geometry.hpp"
#include "striate/config/settings.hpp"

namespace striate::simulator {

/// What is wrong with the eyes in a world, and with what they are told of themselves: what every
/// real head has some of. All off by default: then images are the same to the last bit.
struct EyeFaults {
  double tilt_rad = 0.0;    ///< off unless asked for: both eyes look higher than is told
  double yaw_rad = 0.0;     ///< off unless asked for: the right eye is turned to the left
  double focal = 0.0;       ///< off unless asked for: share that the true focal length is longer
  double baseline = 0.0;    ///< off unless asked for: share that the eyes are farther apart
  double rows_px = 0.0;     ///< off unless asked for: the right eye sees everything higher
  double distortion = 0.0;  ///< off unless asked for: share of the way outwards, at the corner
  double rolling_shutter_s = 0.0;  ///< off unless asked for: from the first row to the last
  double white_balance = 0.0;  ///< off unless asked for: share of red too much, of blue too little
  double lamp_flicker = 0.0;   ///< off unless asked for: share of the light that comes and goes
  double dirt = 0.0;           ///< off unless asked for: share of one lens under dirt
  double fixed_pattern = 0.0;  ///< off unless asked for: spread of the pixels that both eyes share

  bool operator==(const EyeFaults&) const = default;
};

template <class V>
void visit(V& v, EyeFaults& s) {
  using config::Unit;
  v.number("tilt", s.tilt_rad, Unit::angle, {radians(-5), radians(5)},
           "both eyes look higher than is told");
  v.number("yaw", s.yaw_rad, Unit::angle, {radians(-3), radians(3)},
           "the right eye is turned to the left against the left one");
  v.number("focal", s.focal, Unit::fraction, {-0.2, 0.2}, "longer than is told");
  v.number("baseline", s.baseline, Unit::fraction, {-0.2, 0.2}, "longer than is told");
  v.number("rows", s.rows_px, Unit::pixels, {-5, 5},
           "the right eye sees everything so much higher");
  v.number("distortion", s.distortion, Unit::fraction, {-0.2, 0.2},
           "of the way outwards that a corner is off; positive: a barrel");
  v.number("rolling_shutter", s.rolling_shutter_s, Unit::duration, {0.0, 0.1},
           "from the first row to the last one");
  v.number("white_balance", s.white_balance, Unit::fraction, {-0.5, 0.5},
           "red too strong, blue too weak");
  v.number("lamp_flicker", s.lamp_flicker, Unit::fraction, {0.0, 0.9},
           "of the light, 100 times a second");
  v.number("dirt", s.dirt, Unit::fraction, {0.0, 0.5}, "of one lens that is covered");
  v.number("fixed_pattern", s.fixed_pattern, Unit::fraction, {0.0, 0.2},
           "spread of the pixels' sensitivity that both eyes share");
}

}  // namespace striate::simulator
