#pragma once

#include "striate/config/settings.hpp"

namespace striate::perception {

/// How obstacles are told from the floor.
struct ObstacleSettings {
  /// What is lower counts as floor: one px of disparity is worth so much height 1.2 m away
  double lowest_m = 0.06;
  /// What hangs higher is no obstacle: 0.2 m above the camera, the robot's top
  double highest_m = 1.4;
  double farthest_m = 10.0;  ///< farther things are left unknown: one px of disparity is 4 m there
  /// The floor is not judged beyond: one px of disparity is 2.6 m there
  double farthest_floor_m = 8.0;
  /// Least confidence of a disparity: lets all promises (0.5 and more) in; of scores of 0.3 69 %
  /// are right (confidence_fit)
  double trusted = 0.3;
  /// Disparity above the floor line that is still the floor; by true depth (obstacle_table)
  double floor_margin_px = 0.6;
  /// Disparity above the floor line that surely stands up; by true depth (obstacle_table)
  double standing_px = 1.6;
  double smallest_m = 0.06;  ///< visible height that an obstacle must show: all of the lowest one
  double smallest_px = 8.0;  ///< and in pixels, at any distance; by true depth (obstacle_table)
  /// Largest correction of the floor line, 0: none; rectification errs by 0.15 px
  double floor_offset_px = 0.4;
  /// Unknown floor up to this length is bridged: less than the robot is long (0.5 m)
  double floor_gap_m = 0.4;
  /// Unknown columns between parts of one plane that are bridged: 8 deg at width 160 (ours)
  int bridged_columns = 30;
  /// Paper setting: disparities above are obstacles; 3 m away. The paper gives no figure
  double paper_threshold_px = 8.0;
  /// Paper setting: smaller blobs are noise. The paper gives no figure
  int paper_smallest_px = 40;
};

template <class V>
void visit(V& v, ObstacleSettings& s) {
  using config::Unit;
  v.number("lowest", s.lowest_m, Unit::length, {0.01, 0.5}, "what is lower counts as floor");
  v.number("highest", s.highest_m, Unit::length, {0.2, 3.0}, "what hangs higher is no obstacle");
  v.number("farthest", s.farthest_m, Unit::length, {1.0, 50.0}, "farther things stay unknown");
  v.number("farthest_floor", s.farthest_floor_m, Unit::length, {1.0, 50.0},
           "the floor is not judged beyond");
  v.number("trusted", s.trusted, Unit::fraction, {0.0, 1.0}, "least confidence of a disparity");
  v.number("floor_margin", s.floor_margin_px, Unit::pixels, {0.0, 5.0},
           "disparity above the floor line that is still floor");
  v.number("standing", s.standing_px, Unit::pixels, {0.1, 10.0},
           "disparity above the floor line that surely stands up");
  v.number("smallest_height", s.smallest_m, Unit::length, {0.0, 1.0},
           "visible height of an obstacle");
  v.number("smallest_area", s.smallest_px, Unit::pixels, {1.0, 1000.0},
           "least pixels of an obstacle");
  v.number("floor_offset", s.floor_offset_px, Unit::pixels, {0.0, 2.0},
           "largest correction of the floor line by the image itself");
  v.number("floor_gap", s.floor_gap_m, Unit::length, {0.0, 2.0}, "unknown floor that is bridged");
  v.integer("bridged_columns", s.bridged_columns, {0, 640},
            "unknown columns bridged between parts of one plane");
  v.number("paper_threshold", s.paper_threshold_px, Unit::pixels, {0.5, 200.0},
           "paper setting: larger disparities are obstacles");
  v.integer("paper_smallest", s.paper_smallest_px, {1, 100000},
            "paper setting: least pixels of a blob");
}

}  // namespace striate::perception
