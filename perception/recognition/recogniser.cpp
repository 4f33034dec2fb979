#include "perception/recognition/recogniser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/user_error.hpp"

namespace striate {
namespace {

/// The rectangle that encloses what was added.
struct Box {
  double left = std::numeric_limits<double>::infinity(), top = left;
  double right = -left, bottom = -left;

  void add(double u, double v) {
    left = std::min(left, u), right = std::max(right, u);
    top = std::min(top, v), bottom = std::max(bottom, v);
  }
  void write(Recognition& to) const {
    to.u_px = (left + right) / 2, to.v_px = (top + bottom) / 2;
    to.width_px = right - left, to.height_px = bottom - top;
  }
};

void check(const RecognitionSettings& s) {
  auto bits = [](int limit) { return limit >= 1 && limit <= 257; };
  if (!bits(s.limit_bits) || !bits(s.paper_limit_bits)) {
    throw UserError("recognition: limits must be 1 .. 257 bits");
  }
  if (s.least_inliers < 3) throw UserError("recognition: 'least_inliers' must be at least 3");
}

}  // namespace

Recogniser::Recogniser(std::span<const ObjectModel> models, const RecognitionSettings& settings)
    : settings_(settings), consensus_(settings) {
  check(settings);
  for (std::size_t m = 0; m < models.size(); ++m) {
    for (std::size_t v = 0; v < models[m].views.size(); ++v) {
      const ObjectView& view = models[m].views[v];
      views_.push_back({static_cast<int>(m), static_cast<int>(v), store_.size(),
                        view.keypoints.size(), view.width_px, view.height_px});
      for (const Keypoint& point : view.keypoints) {
        store_.append(point.descriptor);
        places_.push_back(place_of(point));
        view_of_.push_back(views_.size() - 1);
      }
    }
  }
}

const std::vector<Recognition>& Recogniser::recognise(std::span<const Keypoint> keypoints) {
  found_.clear();
  queries_.clear();
  for (const Keypoint& point : keypoints) queries_.push_back(point.descriptor);
  if (settings_.setting == RecognitionSetting::paper) {
    recognise_as_in_paper(keypoints);
  } else {
    const auto limit = static_cast<std::uint32_t>(settings_.limit_bits);
    choose_candidates(keypoints, search_.below(queries_, store_, limit));
    sort_by_view();
    for (std::size_t k = 0; k < views_.size(); ++k) {
      const View& view = views_[k];
      const auto pairs = std::span(pairs_).subspan(starts_[k], starts_[k + 1] - starts_[k]);
      if (pairs.size() < static_cast<std::size_t>(settings_.least_inliers)) continue;
      const Consensus consensus = consensus_.find(pairs, view.width_px, view.height_px);
      if (consensus.inliers < settings_.least_inliers) continue;
      Recognition recognition{.object = view.object, .view = view.number};
      recognition.inliers = consensus.inliers;
      recognition.scale = consensus.pose.scale();
      recognition.matched_fraction = consensus.inliers / static_cast<double>(view.count);
      Box box;
      for (const double u : {-0.5, view.width_px - 0.5}) {
        for (const double v : {-0.5, view.height_px - 0.5}) {
          box.add(consensus.pose.u_of(u, v), consensus.pose.v_of(u, v));
        }
      }
      box.write(recognition);
      keep(recognition);
    }
  }
  // At most one entry an object, so that the order is total.
  std::ranges::sort(found_, [](const Recognition& a, const Recognition& b) {
    return a.inliers != b.inliers ? a.inliers > b.inliers : a.object < b.object;
  });
  return found_;
}

/// The paper's rule (its section on recognition): at least half of a view's descriptors have a
/// match with a Hamming distance below 48. Where they lie is not looked at.
void Recogniser::recognise_as_in_paper(std::span<const Keypoint> keypoints) {
  const auto limit = static_cast<std::uint32_t>(settings_.paper_limit_bits);
  nearest_.assign(store_.size(), Match{0, 0, limit});
  for (const Match& match : search_.below(queries_, store_, limit)) {
    if (match.distance_bits < nearest_[match.stored].distance_bits) nearest_[match.stored] = match;
  }
  for (const View& view : views_) {
    int matched = 0;
    Box box;
    for (const Match& match : std::span(nearest_).subspan(view.first, view.count)) {
      if (match.distance_bits >= limit) continue;
      ++matched;
      box.add(keypoints[match.query].u_px, keypoints[match.query].v_px);
    }
    Recognition recognition{.object = view.object, .view = view.number};
    recognition.inliers = matched;
    recognition.matched_fraction = matched / std::max(1.0, static_cast<double>(view.count));
    if (matched == 0 || recognition.matched_fraction < settings_.paper_share) continue;
    box.write(recognition);
    keep(recognition);
  }
}

/// One object is reported once: by the view that most of it agrees with.
void Recogniser::keep(const Recognition& recognition) {
  const auto same = std::ranges::find(found_, recognition.object, &Recognition::object);
  if (same == found_.end()) {
    found_.push_back(recognition);
    return;
  }
  const bool better = settings_.setting == RecognitionSetting::paper
                          ? recognition.matched_fraction > same->matched_fraction
                          : recognition.inliers > same->inliers;
  if (better) *same = recognition;
}

/// @param matches by keypoint, then by stored index: those of one view lie together.
void Recogniser::choose_candidates(std::span<const Keypoint> keypoints,
                                   std::span<const Match> matches) {
  candidates_.clear();
  for (std::size_t from = 0, to = 0; from < matches.size(); from = to) {
    const std::size_t view = view_of_[matches[from].stored];
    while (to < matches.size() && matches[to].query == matches[from].query &&
           view_of_[matches[to].stored] == view) {
      ++to;
    }
    add_candidate(keypoints[matches[from].query], matches.subspan(from, to - from));
  }
}

/// The nearest keypoint of a view, if another place of the view is not nearly as near.
void Recogniser::add_candidate(const Keypoint& keypoint, std::span<const Match> of_view) {
  const Match& first = *std::ranges::min_element(of_view, {}, &Match::distance_bits);
  const Place& place = places_[first.stored];
  double second_bits = settings_.limit_bits;
  for (const Match& match : of_view) {
    const Place& other = places_[match.stored];
    // The same place at a neighbouring scale is no rival.
    if (std::hypot(other.u_px - place.u_px, other.v_px - place.v_px) < place.size_px) continue;
    second_bits = std::min<double>(second_bits, match.distance_bits);
  }
  if (first.distance_bits >= settings_.ratio * second_bits) return;
  const std::size_t view = view_of_[first.stored];
  const int point = static_cast<int>(first.stored - views_[view].first);
  candidates_.push_back({view, {place, place_of(keypoint), point}});
}

void Recogniser::sort_by_view() {
  starts_.assign(views_.size() + 2, 0);
  for (const Candidate& candidate : candidates_) ++starts_[candidate.view + 2];
  for (std::size_t k = 2; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
  pairs_.resize(candidates_.size());
  // Afterwards the start of view k + 1 has moved to entry k + 1.
  for (const Candidate& candidate : candidates_) {
    pairs_[starts_[candidate.view + 1]++] = candidate.pair;
  }
}

}  // namespace striate
