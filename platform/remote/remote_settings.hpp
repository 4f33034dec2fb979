#pragma once

#include "striate/base/limits.hpp"
#include "striate/config/settings.hpp"

namespace striate::remote {

/// Deadlines and the camera's numbers of a robot that is heard and led through messages, whatever
/// carries them.
struct RemoteSettings {
  double pairing_s = 0.02;  ///< a fifth of the cycle; synchronised eyes differ by much less
  double stale_s = 0.5;     ///< five images missed at 10 Hz
  double lost_s = 5.0;      ///< ten times stale_s: what has not come back by then will not (ours)
  double lease_s =
      to_seconds(kCommandLease);  ///< five cycles at 10 Hz, as the Pioneer's safety gate
  double seen_old_s = to_seconds(kCommandLease);     ///< as the Pioneer's safety gate
  double longest_gap_s = to_seconds(kCommandLease);  ///< as the Pioneer's safety gate
  double command_gap_s = 1.0;                        ///< as the Pioneer's safety gate
  double focal_px = 0.0;                             ///< 0: as CameraInfo says
  double baseline_m = 0.0;                           ///< 0: as CameraInfo says
  double fixed_tilt_rad = 0.0;                       ///< a head that looks straight ahead
  double scan_forward_m = 0.0;                       ///< above the axle, unless told
};

template <class V>
void visit(V& v, RemoteSettings& s) {
  using config::Unit;
  v.number("pairing", s.pairing_s, Unit::duration, {0.0, 0.2},
           "left and right belong together when their stamps differ by no more");
  v.number("stale", s.stale_s, Unit::duration, {0.1, 2.0},
           "the robot stands when images or odometry are silent for so long");
  v.number("lost", s.lost_s, Unit::duration, {0.5, 600.0},
           "the mission ends when they are silent for so long");
  v.number("lease", s.lease_s, Unit::duration, {0.05, 0.5}, "an older command does not drive");
  v.number("seen_old", s.seen_old_s, Unit::duration, {0.1, 0.5},
           "a command does not drive when the image it was decided by is older");
  v.number("longest_gap", s.longest_gap_s, Unit::duration, {0.3, 1.0},
           "after not running for so long, as when suspended, it stands until it is reset");
  v.number("command_gap", s.command_gap_s, Unit::duration, {0.5, 10.0},
           "without a command for so long in the midst of motion it stands until it is reset");
  v.number("focal", s.focal_px, Unit::none, {0.0, 100000.0},
           "px; 0: as CameraInfo says; counts before it");
  v.number("baseline", s.baseline_m, Unit::length, {0.0, 10.0},
           "distance of the eyes; 0: as CameraInfo says; counts before it");
  v.number("fixed_tilt", s.fixed_tilt_rad, Unit::angle, {-1.0, 1.0},
           "of a head without joints, up positive");
  v.number("scan_forward", s.scan_forward_m, Unit::length, {-1.0, 1.0},
           "place of the laser ahead of the axle");
}

}  // namespace striate::remote
