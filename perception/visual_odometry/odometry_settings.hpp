#pragma once

#include "striate/config/settings.hpp"

namespace striate::perception {

/// Stereo visual odometry. What was chosen by measuring is in the README.
struct VisualOdometrySettings {
  int width_px = 0;          ///< images are narrowed to it; 0: as they are
  int most_features = 1000;  ///< an eye
  double row_px = 2.0;       ///< that the eyes' rows may differ
  double window = 0.05;  ///< of the width: how far from the expected place a point is looked for
  double wide_window = 0.15;     ///< the same where nothing was found, or nothing is expected
  int least_points = 20;         ///< that both eyes see, and that agree on a motion
  double least_share = 0.35;     ///< of the matched points that agree
  double keep_share = 0.6;       ///< of a keyframe's points that are still followed: else a new one
  int keyframes = 5;             ///< that are refined together; 1: none
  double most_turn_rad = 0.6;    ///< from image to image
  double most_way = 1.0;         ///< from image to image, of the median distance of what is seen
  double most_doubt = 0.1;       ///< standard deviation of the way, of that distance
  double most_doubt_rad = 0.03;  ///< standard deviation of the turn
  int most_lost = 5;             ///< images without an estimate, then it begins anew
};

template <class V>
void visit(V& v, VisualOdometrySettings& s) {
  using config::Unit;
  v.integer("width", s.width_px, {0, 4096}, "images are narrowed to it; 0: as they are");
  v.integer("most_features", s.most_features, {50, 20000}, "keypoints of an eye");
  v.number("row", s.row_px, Unit::pixels, {0.5, 20.0}, "that the eyes' rows may differ");
  v.number("window", s.window, Unit::fraction, {0.005, 0.5},
           "of the width: how far from where it is expected a point is looked for");
  v.number("wide_window", s.wide_window, Unit::fraction, {0.005, 1.0},
           "the same where nothing was found");
  v.integer("least_points", s.least_points, {6, 10000}, "that must agree on a motion");
  v.number("least_share", s.least_share, Unit::fraction, {0.0, 1.0},
           "of the matched points, that must agree");
  v.number("keep_share", s.keep_share, Unit::fraction, {0.0, 1.0},
           "of a keyframe's points: with fewer in view a new keyframe is made");
  v.integer("keyframes", s.keyframes, {1, 20}, "that are refined together; 1: none");
  v.number("most_turn", s.most_turn_rad, Unit::angle, {0.01, 3.0}, "from image to image");
  v.number("most_way", s.most_way, Unit::none, {0.01, 10.0},
           "from image to image, of the median distance of what is seen");
  v.number("most_doubt", s.most_doubt, Unit::none, {0.001, 10.0},
           "standard deviation of the way, of that distance");
  v.number("most_doubt_turn", s.most_doubt_rad, Unit::angle, {0.001, 3.0},
           "standard deviation of the turn");
  v.integer("most_lost", s.most_lost, {0, 1000},
            "images without an estimate; then it begins anew from where it is");
}

}  // namespace striate::perception
