#pragma once

namespace striate::perception {

/// Stereo visual odometry. What was chosen by measuring is in the README.
struct VisualOdometrySettings {
  int width_px = 0;              ///< images are narrowed to it; 0: as they are
  int most_features = 1000;      ///< an eye; > 0
  double row_px = 2.0;           ///< that the eyes' rows may differ; > 0
  double window = 0.05;          ///< of the width: how far from the expected place it is looked for
  double wide_window = 0.15;     ///< the same where nothing was found, or nothing is expected
  int least_points = 20;         ///< that both eyes see, and that agree on a motion; >= 6
  double least_share = 0.35;     ///< of the matched points that agree; 0..1
  double keep_share = 0.6;       ///< of a keyframe's points that are still followed: else a new one
  int keyframes = 5;             ///< that are refined together; 1: none
  double most_turn_rad = 0.6;    ///< from image to image
  double most_way = 1.0;         ///< from image to image, of the median distance of what is seen
  double most_doubt = 0.1;       ///< standard deviation of the way, of that distance
  double most_doubt_rad = 0.03;  ///< standard deviation of the turn
  int most_lost = 5;             ///< images without an estimate, then it begins anew; >= 0
};

}  // namespace striate::perception
