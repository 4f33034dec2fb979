#include <algorithm>
#include <cmath>
#include <iterator>

#include "striate/perception/recognition/recogniser.hpp"

namespace striate::perception {

/// How far agreement is beyond chance, on a scale from 0 to 1 on which 0.5 is enough: in a memory
/// with more views, and among more pairs, chance has more opportunities.
double Recogniser::evidence(std::span<const PlacePair> agreeing, const Found& of) {
  residuals_of(agreeing, of.pose, of.side_px, residuals_);
  const double chance = std::log10(static_cast<double>(std::max<std::size_t>(1, in_use_))) +
                        log10_chance(of.all, residuals_, of.carried);
  return score_of_chance(chance, settings_.most_chance);
}

/// From afar only the coarse keypoints of a view can be seen: of them, the share that agrees, and
/// whether those lie all over what is seen.
bool Recogniser::agrees_all_over(const View& view, const Consensus& consensus, double own,
                                 double least_share) {
  if (least_share <= 0.0 && settings_.least_spread <= 0.0) return true;
  // Of the finest keypoint's size: scales are sqrt(2) apart, so half a step is 0.84 (ours)
  constexpr double kAboutAsLarge = 0.9;
  const double least_px = kAboutAsLarge * finest_px_ / consensus.pose.scale();
  visible_.clear();
  std::ranges::copy_if(view.places, std::back_inserter(visible_), [&](const KeypointFrame& place) {
    return place.size_px >= least_px && !view.shared.holds(place);
  });
  const double share = own * consensus.inliers / std::max<double>(1.0, visible_.size());
  return share >= least_share &&
         spread(visible_, agreeing_, view.width_px, view.height_px) >= settings_.least_spread;
}

}  // namespace striate::perception
