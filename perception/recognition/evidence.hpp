#pragma once

#include <span>
#include <vector>

#include "striate/perception/recognition/consensus.hpp"

namespace striate::perception {

/// How a view's pairs lie against the pose that most of them agree with.
struct PairsUnderPose {
  int pairs = 0;           ///< all of them
  double within = 0.0;     ///< 0..1: share whose place in the image lies in the view's outline
  double as_turned = 0.0;  ///< 0..1: share that says about the same turn and size
};

[[nodiscard]] PairsUnderPose pairs_under(std::span<const PlacePair> pairs, const Pose& pose,
                                         double width_px, double height_px);

/// How far the image's keypoints lie from where the pose puts those of the view, as shares of the
/// view's side: one for each different keypoint, ascending.
void residuals_of(std::span<const PlacePair> agreeing, const Pose& pose, double side_px,
                  std::vector<double>& residuals);

/// log10 of how many poses that fit so well are to be expected in one comparison where all pairs
/// are wrong: choices of the pairs that agree, of the three that carry the pose, and the chance
/// that each other one lies as near as the worst of them; of all numbers of pairs the least. After
/// Moisan and Stival (2004), "A probabilistic criterion to detect rigid point matches between two
/// images". The chance of one pair is measured from the pairs themselves, since neither places nor
/// turns in an image are uniform. Infinite where no more agree than carry a pose. It is a bound: of
/// 7400 comparisons with what was not there 4 fell below 0 and 2 below -1 (jsk_arc2017 in
/// corridors, aisles and streets).
/// @param residuals as residuals_of() gives them
/// @param carried pairs, 0 to 3, that carry the pose and are not among the residuals
[[nodiscard]] double log10_chance(const PairsUnderPose& all, std::span<const double> residuals,
                                  int carried = 0);

/// What a recognition that is expected so often by chance is worth: 0 to 1, 0.5 where it is as rare
/// as it must be, 0.75 where it is 10^10 times rarer.
[[nodiscard]] double score_of_chance(double log10_expected, double most_chance);
/// log10 of how often it is expected by chance: the inverse.
[[nodiscard]] double log10_expected_of(double score, double most_chance);

/// How evenly agreeing keypoints lie on a view, cut into 4 x 4 parts: the parts that hold one, over
/// the number that would if each keypoint of the view agreed with the same chance. About 1 for the
/// thing itself, near 0 for a label that another thing has, too.
/// @param visible places of the view that are large enough to be seen at the found scale
[[nodiscard]] double spread(std::span<const KeypointFrame> visible,
                            std::span<const PlacePair> agreeing, double width_px, double height_px);

}  // namespace striate::perception
