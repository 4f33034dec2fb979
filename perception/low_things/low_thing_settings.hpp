#pragma once

#include "striate/config/settings.hpp"

namespace striate::perception {

/// What stands so low on the floor near by that it is about one pixel of the working size.
struct LowThingSettings {
  bool on = true;
  /// Seen so far ahead at most, from the camera's foot: one px of the finer size is 9 cm there
  double farthest_m = 3.2;
  double lowest_m = 0.045;  ///< what is lower is floor: the base drives over a cable or a doormat
  double highest_m = 0.40;  ///< what is higher is seen at the working size
  /// Disparity above the floor line that is still floor, px of the finer size; low_things_table
  double floor_margin_px = 0.6;
  /// Disparity above the floor line that surely stands; low_things_table
  double standing_px = 1.2;
  /// How many times better than the floor a disparity must explain its patch; low_things_table
  double refuted = 1.5;
  double smallest_m = 0.05;   ///< visible height that must agree
  double smallest_px = 14.0;  ///< and pixels; low_things_table
};

template <class V>
void visit(V& v, LowThingSettings& s) {
  using config::Unit;
  v.flag("on", s.on, "look for low things at twice the working size (mode robust)");
  v.number("farthest", s.farthest_m, Unit::length, {1.0, 10.0}, "low things are sought up to here");
  v.number("lowest", s.lowest_m, Unit::length, {0.01, 0.5}, "what is lower counts as floor");
  v.number("highest", s.highest_m, Unit::length, {0.1, 1.0},
           "what is higher is left to the working size");
  v.number("floor_margin", s.floor_margin_px, Unit::pixels, {0.0, 5.0},
           "disparity above the floor line that is still floor");
  v.number("standing", s.standing_px, Unit::pixels, {0.1, 10.0},
           "disparity above the floor line that surely stands");
  v.number("refuted", s.refuted, Unit::none, {1.0, 100.0},
           "how many times better than the floor a disparity must explain its patch");
  v.number("smallest_height", s.smallest_m, Unit::length, {0.0, 1.0}, "visible height of a thing");
  v.number("smallest_area", s.smallest_px, Unit::pixels, {1.0, 1000.0}, "least pixels of a thing");
}

}  // namespace striate::perception
