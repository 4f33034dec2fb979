#pragma once

#include "striate/config/settings.hpp"

namespace striate::perception {

/// Things that move apart from the robot's own motion.
struct MotionSettings {
  bool on = false;
  /// Between the two images that are compared; chosen on corridor_a (motion_table)
  double gap_s = 0.5;
  /// Disparities of less confidence are not used; as the obstacles' (ObstacleSettings)
  double trusted = 0.3;
  /// Of what is judged, above the floor: one px of disparity is worth it in height 2 m away
  double lowest_m = 0.1;
  double highest_m = 2.0;  ///< and below this: people
  /// Disparities that differ by less are the same place ...; 0.8 found less (motion_table)
  double tolerance_px = 0.35;
  double tolerance = 0.03;  ///< ... or by less than this share; chosen on corridor_a (motion_table)
  /// So far from its predicted place a pixel may be found again: odometry errs (ours)
  int slack_px = 2;
  /// What seems to move more slowly stands: 0.1 m in gap_s, one px of disparity at 1.6 m
  double slowest_m_s = 0.2;
  double fastest_m_s = 2.5;  ///< velocities are searched up to this: a person's fast walk
  /// Columns that a moving thing must have: a leg at 3.5 m (0.1 m x 203 px / 3.5 m)
  int narrowest_px = 6;
  double least_share = 0.5;  ///< of a column's obstacle that must have been free before: most of it
};

template <class V>
void visit(V& v, MotionSettings& s) {
  using config::Unit;
  v.flag("on", s.on,
         "look for things that move by themselves; off: no behaviour uses them yet, and the "
         "trials that are reported were driven without");
  v.number("gap", s.gap_s, Unit::duration, {0.05, 2.0}, "between the images compared");
  v.number("trusted", s.trusted, Unit::fraction, {0.0, 1.0}, "least confidence of a disparity");
  v.number("lowest", s.lowest_m, Unit::length, {0.0, 1.0}, "what is lower is not judged");
  v.number("highest", s.highest_m, Unit::length, {0.2, 3.0}, "what is higher is not judged");
  v.number("tolerance", s.tolerance_px, Unit::pixels, {0.1, 10.0},
           "disparities that differ by less are the same place");
  v.number("tolerance_share", s.tolerance, Unit::fraction, {0.0, 0.5},
           "or by less than this share of the disparity");
  v.integer("slack", s.slack_px, {0, 8}, "error of the predicted place");
  v.number("slowest", s.slowest_m_s, Unit::speed, {0.0, 2.0}, "slower things stand");
  v.number("fastest", s.fastest_m_s, Unit::speed, {0.1, 10.0}, "largest velocity searched");
  v.integer("narrowest", s.narrowest_px, {1, 160}, "columns of a moving thing");
  v.number("least_share", s.least_share, Unit::fraction, {0.05, 1.0},
           "of a column's obstacle that must have been free before");
}

}  // namespace striate::perception
