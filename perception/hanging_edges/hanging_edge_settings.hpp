#pragma once

#include "striate/config/settings.hpp"

namespace striate::perception {

/// Edges that hang over the floor and show nothing to stereo, since they run along its rows: the
/// top of a bar table, a shelf, a counter.
struct HangingEdgeSettings {
  bool on = true;
  double lowest_m = 0.30;    ///< lower edges belong to things that stand
  double highest_m = 1.30;   ///< 0.1 m above the camera, the robot's top
  double farthest_m = 3.5;   ///< an end errs by 1 px of twice the working size: 0.25 m there
  double shortest_m = 0.25;  ///< narrower things are seen by their own two sides
};

template <class V>
void visit(V& v, HangingEdgeSettings& s) {
  using config::Unit;
  v.flag("on", s.on, "find level edges over the floor by their ends (mode robust)");
  v.number("lowest", s.lowest_m, Unit::length, {0.0, 2.0}, "lower edges are left to stereo");
  v.number("highest", s.highest_m, Unit::length, {0.2, 3.0}, "higher edges are in nobody's way");
  v.number("farthest", s.farthest_m, Unit::length, {0.5, 10.0}, "farther edges are left unknown");
  v.number("shortest", s.shortest_m, Unit::length, {0.05, 5.0}, "shorter edges are left to stereo");
}

}  // namespace striate::perception
