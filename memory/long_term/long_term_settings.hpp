#pragma once

#include "striate/config/settings.hpp"

namespace striate::memory {

/// How the long-term memory learns and forgets. The group's papers publish no constants; these are
/// ours, by hand (memory/README.md), but for the decay, which is ACT-R's usual 0.5.
struct LongTermSettings {
  double decay = 0.5;              ///< d of ACT-R
  double goal_spread = 2.0;        ///< added to the activation of what the task is after
  double route_spread = 1.0;       ///< added where a route leads there from what is in sight
  double start_strength = 0.5;     ///< of a new landmark
  double consolidation = 0.25;     ///< a sighting: s += 0.25 (1 - s)
  double enfeeblement = 0.9;       ///< a missed opportunity: s *= 0.9
  int missed_frames = 3;           ///< frames in a row that make one missed opportunity
  double new_use_after_m = 0.5;    ///< seen again from nearer than this is the same use
  double weak_below = 0.2;         ///< strength below which a landmark may be forgotten
  double inactive_below = -5.0;    ///< base-level activation below which it may be
  double gone_after_s = 180000.0;  ///< retired so long, 50 h of work, it may be removed for good
  int most_views = 8;              ///< of a landmark
  int most_keypoints = 400;        ///< of a view, the strongest
  int least_keypoints = 12;        ///< fewer can never be recognised
  int few_keypoints = 40;          ///< fewer are said to be few
  int alike_inliers = 12;          ///< keypoints that agree on a pose: the same thing
  double alike_share = 0.7;        ///< of a view's keypoints that agree: the same view
  int most_episodes = 20000;       ///< that prune leaves, the newest
};

template <class V>
void visit(V& v, LongTermSettings& s) {
  using config::Unit;
  v.number("decay", s.decay, Unit::none, {0.05, 0.95}, "how fast activation fades, d of ACT-R");
  v.number("goal_spread", s.goal_spread, Unit::none, {0.0, 20.0},
           "activation added to what the task is after");
  v.number("route_spread", s.route_spread, Unit::none, {0.0, 20.0},
           "activation added where a route leads there from what is in sight");
  v.number("start_strength", s.start_strength, Unit::fraction, {0.01, 0.99},
           "strength of a new landmark");
  v.number("consolidation", s.consolidation, Unit::fraction, {0.0, 0.99},
           "share of what is missing to full strength that a sighting gives");
  v.number("enfeeblement", s.enfeeblement, Unit::fraction, {0.01, 1.0},
           "what a missed opportunity leaves of the strength");
  v.integer("missed_frames", s.missed_frames, {1, 1000},
            "frames in a row that make one missed opportunity");
  v.number("new_use_after", s.new_use_after_m, Unit::length, {0.0, 100.0},
           "seen again from nearer than this is the same use");
  v.number("weak_below", s.weak_below, Unit::fraction, {0.0, 1.0},
           "strength below which a landmark may be forgotten");
  v.number("inactive_below", s.inactive_below, Unit::none, {-100.0, 100.0},
           "base-level activation below which a landmark may be forgotten");
  v.number("gone_after", s.gone_after_s, Unit::duration, {0.0, 1e9},
           "retired so long, a landmark may be removed for good");
  v.integer("most_views", s.most_views, {1, 1000}, "views that a landmark keeps");
  v.integer("most_keypoints", s.most_keypoints, {12, 10000}, "keypoints that a view keeps");
  v.integer("least_keypoints", s.least_keypoints, {1, 10000},
            "a view with fewer keypoints is not taken");
  v.integer("few_keypoints", s.few_keypoints, {1, 10000},
            "a view with fewer keypoints is taken with a warning");
  v.integer("alike_inliers", s.alike_inliers, {3, 1000},
            "keypoints that must agree for two views to show the same thing");
  v.number("alike_share", s.alike_share, Unit::fraction, {0.05, 1.0},
           "of the keypoints that must agree for two views to be the same");
  v.integer("most_episodes", s.most_episodes, {1, 100000000}, "episodes that prune leaves");
}

}  // namespace striate::memory
