#pragma once

#include "striate/base/pioneer_devices.hpp"
#include "striate/config/settings.hpp"

namespace striate::pioneer {

enum class LaserKind { hokuyo, lms200 };

/// What both kinds of laser need to know.
struct LaserSettings {
  LaserKind kind = LaserKind::hokuyo;
  double forward_m = kLaserForward_m;  ///< mount of an LMS-200 on a P3-DX (ARIA's p3dx-sh.p)
  double reply_patience_s = 0.5;       ///< five scans: a reply waits behind one that is being sent
  double stale_after_s = 0.5;          ///< five scans missed at 10 Hz; as the safety gate's
  double begin_again_after_s = 1.0;    ///< ten scans missed at 10 Hz
};

template <class V>
void visit(V& v, LaserSettings& s) {
  using config::Unit;
  v.choice("kind", s.kind, {"hokuyo", "lms200"}, "SCIP 2.0, or a SICK LMS-200");
  v.number("forward", s.forward_m, Unit::length, {-0.5, 0.5}, "of the laser before the axle");
  v.number("reply_patience", s.reply_patience_s, Unit::duration, {0.05, 10.0},
           "for the reply to a command; then the device is set up from the start");
  v.number("stale_after", s.stale_after_s, Unit::duration, {0.1, 5.0}, "an older scan is none");
  v.number("begin_again_after", s.begin_again_after_s, Unit::duration, {0.2, 60.0},
           "without a scan the device is set up from the start");
}

}  // namespace striate::pioneer
