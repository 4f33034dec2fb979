#pragma once

#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "striate/perception/recognition/recognition_settings.hpp"

namespace striate::perception {

/// When a place counts as known again.
struct PlaceSettings {
  /// That the gist proposes, each of which is compared by its keypoints. In a real corridor the
  /// right one was always among five (gist/README); twice that, for buildings that are larger
  int proposals = 10;
  /// Powers of ten by which the agreement is rarer than chance. Of places never seen before the
  /// most alike had 64, of places seen before one in ten had less than 113 (rtabmap_samples and the
  /// simulator's corridor_a)
  double least_evidence = 80.0;
  /// Evidence over that of the best other place: alike doors in a row are no place (ours)
  double least_lead = 1.25;
  /// Of an image, strongest first; 1500 took three times as long and found no more (same images)
  int most_keypoints = 800;
  /// How keypoints must agree: one view of the place, hardly turned, seen from nearer or farther
  RecognitionSettings matching{.most_chance = 1.0, .least_scale = 0.4, .most_turn_rad = 0.5};
};

}  // namespace striate::perception
