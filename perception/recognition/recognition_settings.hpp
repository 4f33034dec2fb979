#pragma once

#include "striate/config/settings.hpp"

namespace striate::perception {

enum class RecognitionMode { paper, robust };

/// When an object counts as recognised.
struct RecognitionSettings {
  RecognitionMode mode = RecognitionMode::robust;
  int paper_limit_bits = 48;  ///< paper: a match is below it; section on recognition
  /// Paper: of a view's descriptors that must have a match; section on recognition
  double paper_share = 0.5;
  /// Robust: candidates are below it; the middle of what was tried (tests/evaluation, Objects)
  int limit_bits = 80;
  /// Robust: nearest over second nearest of the same view; tests/evaluation, Objects
  double ratio = 0.85;
  /// Robust: keypoints that agree on a pose, however unlikely by chance: two more than carry it
  int least_inliers = 5;
  /// Robust: recognitions by chance that are let through, expected in one look at all views. At
  /// five looks a second one in three minutes, and memory asks for several looks (ours)
  double most_chance = 0.001;
  /// Of the view's side, when pairs vote: a pair's own angle and size err (ours)
  double vote_tolerance = 0.15;
  /// Of the view's side, when the pose is fitted; 0.03 did no better (tests/evaluation, Objects)
  double fit_tolerance = 0.04;
  /// How much longer one direction may be drawn than the other: a side seen 66 deg aslant
  double most_stretch = 2.5;
  /// Of the view in the image, its inverse is the largest: taught at 0.6 m, seen at 4 m (ours)
  double least_scale = 0.15;
  /// Of a view's keypoints large enough at that scale; 0: any. The cycle asks for 0.12
  double least_share = 0.0;
  /// The same where memory expects the landmark: from 40 deg beside the place where it was taught 3
  /// to 6 % of a book's keypoints agreed, which elsewhere are too few (ours). The cycle asks for
  /// 0.03
  double least_share_expected = 0.0;
  /// Of the parts of a view that so many agreeing keypoints would lie in, were they anywhere on it:
  /// those that they do lie in. Seen things had 0.48 to 1 (jsk_arc2017), labels on other things
  /// below 0.3. 0: any. The cycle asks for 0.35
  double least_spread = 0.0;
  /// How far the view may be turned in the image; pi: any way. The cycle allows 45 deg
  double most_turn_rad = 3.2;
};

template <class V>
void visit(V& v, RecognitionSettings& s) {
  using config::Unit;
  v.renamed("setting", "mode");
  v.choice("mode", s.mode, {"paper", "robust"}, "the paper's rule, or with geometry");
  v.integer("paper_limit", s.paper_limit_bits, {1, 257}, "bits; a match of the paper is below it");
  v.number("paper_share", s.paper_share, Unit::fraction, {0.0, 1.0},
           "of a view's descriptors that must have a match");
  v.integer("limit", s.limit_bits, {1, 257}, "bits; candidates of a pair are below it");
  v.number("ratio", s.ratio, Unit::none, {0.0, 1.0},
           "a pair counts if its distance is so much below that of the second nearest");
  v.integer("least_inliers", s.least_inliers, {3, 1000}, "keypoints that must agree on a pose");
  v.number("most_chance", s.most_chance, Unit::none, {1e-12, 1e9},
           "recognitions by chance expected in one look at all views");
  v.number("vote_tolerance", s.vote_tolerance, Unit::fraction, {0.01, 1.0},
           "of the view's side, when pairs vote");
  v.number("fit_tolerance", s.fit_tolerance, Unit::fraction, {0.005, 0.5},
           "of the view's side, when the pose is fitted");
  v.number("most_stretch", s.most_stretch, Unit::none, {1.0, 10.0},
           "how much longer one direction may be drawn than the other");
  v.number("least_scale", s.least_scale, Unit::none, {0.01, 1.0},
           "smallest scale of a view; its inverse is the largest");
  v.number("least_share", s.least_share, Unit::fraction, {0.0, 1.0},
           "of a view's keypoints, those large enough to be seen at its scale, that must agree");
  v.number("least_share_expected", s.least_share_expected, Unit::fraction, {0.0, 1.0},
           "the same where memory expects the landmark");
  v.number("least_spread", s.least_spread, Unit::fraction, {0.0, 1.0},
           "how evenly the agreeing keypoints must lie on what is seen of the view");
  v.number("most_turn", s.most_turn_rad, Unit::angle, {0.0, 3.2},
           "how far a view may be turned in the image");
}

}  // namespace striate::perception
