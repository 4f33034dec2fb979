#include <algorithm>
#include <cmath>

#include "striate/perception/recognition/recogniser.hpp"

namespace striate::perception {

/// Compares a view with those of other landmarks, once. What agrees on a pose there says nothing of
/// which of the two it is.
void Recogniser::find_shared_parts(View& view) {
  view.shared.begin(view.places, view.width_px, view.height_px);
  for (const View& other : views_) {
    if (!other.in_use || other.landmark == view.landmark) continue;
    find_pairs(other, view.descriptors, view.places);
    if (pairs_.size() < static_cast<std::size_t>(settings_.least_inliers)) continue;
    const Consensus consensus = consensus_.find(pairs_, other.width_px, other.height_px);
    if (consensus.inliers < settings_.least_inliers) continue;
    const Found why{pairs_under(pairs_, consensus.pose, other.width_px, other.height_px),
                    consensus.pose, std::sqrt(other.width_px * other.height_px)};
    if (is_enough(evidence(consensus_.agreeing(), why))) view.shared.add(consensus_.agreeing());
  }
  view.shared.finish();
}

/// Leaves of the pairs that agree those in parts of the view that no other landmark has.
/// @return how many different keypoints they are; those that only carry the pose may be shared
int Recogniser::keep_what_is_its_own(View& view) {
  const std::span<const PlacePair> found = consensus_.agreeing();
  agreeing_.assign(found.begin(), found.end());
  if (!view.shared.known()) {
    const std::vector<PlacePair> pairs = pairs_;  // once a view
    find_shared_parts(view);
    pairs_ = pairs;
  }
  const int every = different_keypoints(agreeing_, points_);
  if (!view.shared.any()) return every;
  const auto shared = [&](const PlacePair& pair) { return view.shared.holds(pair.view); };
  std::erase_if(agreeing_, shared);
  const int own = different_keypoints(agreeing_, points_);
  compared_.carried = std::min(3, every - own);  // an affine map has six parameters
  const auto own_pairs = pairs_.size() - std::ranges::count_if(pairs_, shared);
  compared_.all.pairs = compared_.carried + static_cast<int>(own_pairs);
  return own + compared_.carried;
}

}  // namespace striate::perception
