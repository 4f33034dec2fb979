#include <algorithm>
#include <cmath>
#include <numeric>

#include "striate/perception/recognition/recogniser.hpp"

namespace striate::perception {

/// Compares a view with those of other landmarks, once. What agrees on a pose there says nothing of
/// which of the two it is.
/// @return whether it has been compared with all of them: of very many with some in each look, so
/// that no look takes long
bool Recogniser::find_shared_parts(View& view) {
  constexpr int kMostInALook = 400;  // as LandmarkFinderSettings::most_views: 16 ms or so (ours)
  if (view.change != change_) {
    view.shared.begin(view.places, view.width_px, view.height_px);
    view.compared = 0;
    view.change = change_;
  }
  if (view.shared.known()) return true;
  descriptors_.clear();
  for (std::size_t k = 0; k < view.store.size(); ++k) descriptors_.push_back(view.store.at(k));
  int left = kMostInALook;
  for (; view.compared < views_.size(); ++view.compared) {
    const View& other = views_[view.compared];
    if (!other.in_use || other.landmark == view.landmark) continue;
    if (left-- == 0) return false;
    find_pairs(other, descriptors_, view.places);
    if (pairs_.size() < static_cast<std::size_t>(settings_.least_inliers)) continue;
    const Consensus consensus = consensus_.find(pairs_, other.width_px, other.height_px);
    if (consensus.inliers < settings_.least_inliers) continue;
    const Found why{pairs_under(pairs_, consensus.pose, other.width_px, other.height_px),
                    consensus.pose, std::sqrt(other.width_px * other.height_px)};
    if (is_enough(evidence(consensus_.agreeing(), why))) view.shared.add(consensus_.agreeing());
  }
  view.shared.finish();
  return true;
}

/// Leaves of the pairs that agree those in parts of the view that no other landmark has.
/// @return how many different keypoints they are; those that only carry the pose may be shared. 0:
/// not yet known
int Recogniser::keep_what_is_its_own(View& view) {
  const std::span<const PlacePair> found = consensus_.agreeing();
  agreeing_.assign(found.begin(), found.end());
  pairs_of_image_.swap(pairs_);
  const bool known = find_shared_parts(view);
  pairs_of_image_.swap(pairs_);
  if (!known) return 0;
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

/// What tells two alike things apart decides, not what they share: a keypoint of the image speaks
/// for the thing that most keypoints speak for, and what is left must do for the others.
void Recogniser::leave_each_keypoint_to_one() {
  order_.resize(found_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::sort(order_, [&](std::size_t i, std::size_t j) {
    const Recognition &a = found_[i], &b = found_[j];
    return a.inliers != b.inliers ? a.inliers > b.inliers : a.landmark < b.landmark;
  });
  claims_.begin_taking();
  for (const std::size_t number : order_) {
    Recognition& found = found_[number];
    const std::span<const PlacePair> left = claims_.left(number);
    const int count = different_keypoints(left, points_) + why_[number].carried;
    const double score = count < found.inliers ? evidence(left, why_[number]) : found.score;
    if (count < settings_.least_inliers || !is_enough(score)) {
      found.inliers = 0;
      continue;
    }
    found.inliers = count;
    found.score = score;
    claims_.take(number);
  }
  std::erase_if(found_, [](const Recognition& found) { return found.inliers == 0; });
}

}  // namespace striate::perception
