#pragma once

#include "striate/config/settings.hpp"

namespace striate::memory {

/// How the robot's place and those of the landmarks are estimated together. Errors are standard
/// deviations. Ours: the papers give none. By hand means as in memory/README.md; together they are
/// judged by `place_table` (tests/evaluation/README.md).
struct LocalisationSettings {
  // Odometry: scales and a drift that stay the same over a run, and what is random.
  double way_error = 0.0075;        ///< the published drift of the base, 0.75 %
  double turn_error = 0.0075;       ///< the same
  double drift_rad_m = 0.0005;      ///< by hand: 0.03 rad in a corridor of 60 m
  double slip_m_root_m = 0.003;     ///< by hand: 0.023 m in 60 m, beside 0.45 m of scale
  double slip_rad_root_m = 0.0015;  ///< by hand: 0.012 rad in 60 m
  // Sightings.
  double bearing_error_rad = 0.01;  ///< two pixels of 203 px focal length
  double disparity_error_px = 0.5;  ///< by hand: above the 0.35 px of a trusted match
  double middle_error_m = 0.05;     ///< by hand: a quarter of a book or box
  double gate = 13.8;               ///< chi squared of 99.9 %, two degrees of freedom
  double new_look_after_m = 0.2;    ///< by hand: nearer looks share their errors
  double new_look_after_rad = 0.1;  ///< by hand: the same
  // Where a run starts.
  bool starts_at_home = true;
  double start_error_m = 0.3;    ///< by hand, as kStartOffsetStd_m of CorridorMemory
  double start_error_rad = 0.1;  ///< by hand, as kStartHeadingStd_rad
  // Routes.
  double pass_within_m = 3.0;  ///< by hand: from wall to wall of a corridor of 2.4 m
};

template <class V>
void visit(V& v, LocalisationSettings& s) {
  using config::Unit;
  v.number("way_error", s.way_error, Unit::fraction, {0, 0.2}, "of the odometry's scale of ways");
  v.number("turn_error", s.turn_error, Unit::fraction, {0, 0.2},
           "of the odometry's scale of turns");
  v.number("drift", s.drift_rad_m, Unit::angle, {0, 0.1}, "turn that each metre seems to make");
  v.number("slip_way", s.slip_m_root_m, Unit::length, {0.0001, 1}, "random, after one metre");
  v.number("slip_turn", s.slip_rad_root_m, Unit::angle, {0.0001, 1}, "random, after one metre");
  v.number("bearing_error", s.bearing_error_rad, Unit::angle, {0.0005, 0.5},
           "of a landmark's bearing by one look");
  v.number("disparity_error", s.disparity_error_px, Unit::pixels, {0.01, 10},
           "of a landmark's disparity: the error of its range grows with the square of the range");
  v.retired("disparity_metre",
            "the camera says it: focal length times baseline comes with each image");
  v.number("middle_error", s.middle_error_m, Unit::length, {0, 1},
           "of what is taken for a landmark's middle");
  v.number("gate", s.gate, Unit::none, {1, 100},
           "squared Mahalanobis distance above which a sighting is another thing");
  v.number("new_look_after", s.new_look_after_m, Unit::length, {0, 10},
           "way after which a look at the same landmark is a new witness");
  v.number("new_look_after_turn", s.new_look_after_rad, Unit::angle, {0, 3},
           "or turn after which it is");
  v.flag("starts_at_home", s.starts_at_home,
         "missions start where the first one did; given up when the first landmark contradicts");
  v.number("start_error", s.start_error_m, Unit::length, {0.001, 10}, "of the place of that start");
  v.number("start_error_heading", s.start_error_rad, Unit::angle, {0.001, 1}, "of its heading");
  v.number("pass_within", s.pass_within_m, Unit::length, {0.5, 20},
           "a landmark passed no farther away than this is a station of a route");
}

}  // namespace striate::memory
