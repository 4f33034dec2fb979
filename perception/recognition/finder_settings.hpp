#pragma once

#include "striate/perception/recognition/recognition_settings.hpp"

namespace striate::perception {

/// How landmarks are looked for in the cycle. The budget counts views and windows, not time, so
/// that the same images give the same recognitions on any machine.
struct LandmarkFinderSettings {
  /// Images; in between nothing is looked for. At 10 Hz five looks a second (ours)
  int every = 2;
  /// Parts of an image that are looked at; each costs time (tests/benchmarks)
  int most_windows = 5;
  /// Of a salient region's side, added on each side: regions are cut within their things (ours)
  double margin = 0.25;
  /// That an image is compared with, the most active first; bounds the time (ours)
  int most_views = 400;
  double most_time_s = 0.0;  ///< of comparing; 0: no limit
  /// Beyond it a landmark is not expected to be recognised; farthest in `trial --objects`
  double farthest_m = 2.5;
  double least_light = 0.12;  ///< mean grey below which nothing is expected to be recognised (ours)
  /// What is nearer by so much hides; twice the depth error of one px 2.5 m away
  double hidden_by_m = 0.5;
  /// The head does not roll and things stand, so a view is not turned much; and what has but a
  /// label in common with a view is another thing.
  RecognitionSettings matching{.least_share = 0.12,
                               .least_share_expected = 0.03,
                               .least_spread = 0.35,
                               .most_turn_rad = 0.785};
};

template <class V>
void visit(V& v, LandmarkFinderSettings& s) {
  using config::Unit;
  v.integer("every", s.every, {1, 100}, "landmarks are looked for in every n-th image");
  v.integer("most_windows", s.most_windows, {1, 20}, "parts of an image that are looked at");
  v.number("margin", s.margin, Unit::fraction, {0.0, 2.0},
           "of a salient region's side, added on each side");
  v.integer("most_views", s.most_views, {1, 10000000},
            "views that an image is compared with, the most active first");
  v.number("most_time", s.most_time_s, Unit::duration, {0.0, 10.0},
           "of comparing in one image; 0: no limit. Runs are then not the same on all machines");
  v.number("farthest", s.farthest_m, Unit::length, {0.5, 20.0},
           "beyond it a landmark is not expected to be recognised");
  v.number("least_light", s.least_light, Unit::fraction, {0.0, 1.0},
           "in a darker image nothing is expected to be recognised");
  v.number("hidden_by", s.hidden_by_m, Unit::length, {0.05, 5.0},
           "what is nearer than the landmark by so much hides it");
  v.section("matching", s.matching);
}

}  // namespace striate::perception
