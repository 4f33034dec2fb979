#pragma once

#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "striate/perception/recognition/recognition_settings.hpp"

namespace striate::perception {

/// When a place counts as known again.
struct PlaceSettings {
  /// That the gist proposes, each of which is compared by its keypoints. Of 42 revisits the right
  /// place, within 2 images, was among the five nearest 40 times, among ten always
  /// (rtabmap_samples)
  int proposals = 10;
  /// Of the neighbours of the best proposal, those that are compared, too: where the gist was near
  /// enough to be of the right corridor, the right metre of it is among them (ours)
  int most_neighbours = 6;
  /// Powers of ten by which the agreement is rarer than chance. Of places never seen before the
  /// most alike had 64 (rtabmap_samples, the simulator's corridor_a), the same street from 14 m
  /// farther back 85 (kitti); of places seen before one in ten had less than 113 (rtabmap_samples)
  double least_evidence = 100.0;
  /// Evidence over that of the best other place: alike doors in a row are no place (ours)
  double least_lead = 1.25;
  /// Of an image, strongest first; 1500 took three times as long and found no more (same images)
  int most_keypoints = 800;
  /// How keypoints must agree: one view of the place, hardly turned, seen from nearer or farther
  RecognitionSettings matching{.most_chance = 1.0, .least_scale = 0.4, .most_turn_rad = 0.5};
};

}  // namespace striate::perception
