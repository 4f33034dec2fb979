#pragma once

#include "striate/behaviours/control/floor_field.hpp"
#include "striate/behaviours/navigation/path_planner.hpp"
#include "striate/config/settings.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// How fast is fast enough to be safe. Ours, by hand (README.md, "Where the numbers come from"),
/// and looked at on `striate trial` in corridor_a to c and the worlds hard_*.
struct SpeedLimitSettings {
  double unknown_m_s = 0.25;  ///< stops within 0.17 m
  double narrow_m_s = 0.15;   ///< stops within 0.08 m
  double roomy_m = 0.35;      ///< in a corridor of 2.4 m there are 0.99 m
  double seen_beside_m = 0.25;
  double latency_s = 0.35;   ///< camera 0.085 s, command 0.06 s and two cycles of 0.1 s: 0.345 s
  double dark_below = 0.12;  ///< light level; hard_dark_people has lamps of 0.1
  double noisy_above = 6.0;  ///< grey levels
  double dim_share = 0.6;
  double moving_stop_m = 0.95;  ///< a walker of 0.9 m/s and one second
  double moving_slow_m = 2.2;   ///< moving_stop_m and 0.97 m to stop from 0.75 m/s: 1.9 m
};

template <class V>
void visit(V& v, SpeedLimitSettings& s) {
  using config::Unit;
  v.number("unknown", s.unknown_m_s, Unit::speed, {0.05, 0.5}, "speed over floor not seen free");
  v.number("narrow", s.narrow_m_s, Unit::speed, {0.05, 0.5}, "speed in the narrowest gaps");
  v.number("roomy", s.roomy_m, Unit::length, {0.1, 1}, "room beside the flanks for full speed");
  v.number("seen_beside", s.seen_beside_m, Unit::length, {0.1, 1},
           "seen floor beside the flanks for full speed");
  v.number("latency", s.latency_s, Unit::duration, {0, 2}, "from light to braking");
  v.number("dark_below", s.dark_below, Unit::fraction, {0, 1}, "light level that counts as dark");
  v.number("noisy_above", s.noisy_above, Unit::none, {0, 50},
           "noise in grey levels that counts as dark");
  v.number("dim_share", s.dim_share, Unit::fraction, {0.1, 1}, "share of the speed in the dark");
  v.number("moving_stop", s.moving_stop_m, Unit::length, {0.3, 3},
           "something moving nearer than this: stand");
  v.number("moving_slow", s.moving_slow_m, Unit::length, {0.5, 5},
           "something moving nearer than this: slow down");
}

/// The speed that what is known allows, and what held it down most.
struct SpeedLimit {
  double speed_m_s = 0.0;
  const char* reason = "";
  double known_free_m = 0.0;        ///< of the way ahead, from the axle
  double unknown_near_share = 0.0;  ///< of the next two metres of the way
  bool waits_for_mover = false;
  double mover_m = perception::kNothing_m;  ///< the nearest thing that moves in front
  double mover_rad = 0.0;                   ///< its bearing
};

/// The nearest thing that moves in front, within the robot's lane; distance kNothing_m if none.
struct Mover {
  double distance_m = perception::kNothing_m;
  double bearing_rad = 0.0;
};
[[nodiscard]] Mover nearest_mover(const memory::ShortTermMemory& memory, double half_lane_m);

[[nodiscard]] SpeedLimit speed_limit_for(const SpeedLimitSettings& settings,
                                         const RobotDescription& robot,
                                         const memory::ShortTermMemory& memory,
                                         const FloorField& field, const Path& way);

}  // namespace striate::behaviours
