#include "striate/perception/places/place_recogniser.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace striate::perception {
namespace {

OrientedSettings place_keypoints(const PlaceSettings& settings) {
  OrientedSettings oriented;
  oriented.keypoints.most = settings.most_keypoints;
  return oriented;
}

std::vector<Keypoint> keypoints_of(const LandmarkView& view) {
  std::vector<Keypoint> keypoints;
  keypoints.reserve(view.keypoints.size());
  for (std::size_t k = 0; k < view.keypoints.size(); ++k) {
    const ViewKeypoint& point = view.keypoints[k];
    keypoints.push_back({.u_px = point.x_px,
                         .v_px = point.y_px,
                         .wavelength_px = point.size_px,
                         .angle_rad = point.angle_rad,
                         .descriptor = view.descriptors[k]});
  }
  return keypoints;
}

/// 0.5 where a ratio is what is asked for.
double confidence_of(double ratio) {
  return ratio / (1.0 + ratio);
}

}  // namespace

PlaceEye::PlaceEye(const PlaceSettings& settings) : keypoints_(place_keypoints(settings)) {}

PlaceView PlaceEye::look(const cv::Mat1b& grey) {
  PlaceView view;
  view.gist = gist_.find(grey);
  view.view = make_view(grey, {0, 0, grey.cols, grey.rows},
                        [&](const cv::Mat1b& image) { return keypoints_(image); });
  return view;
}

PlaceRecogniser::PlaceRecogniser(const PlaceSettings& settings)
    : settings_(settings), recogniser_(settings.matching) {}

int PlaceRecogniser::add(PlaceView view) {
  if (view.view.keypoints.size() != view.view.descriptors.size()) {
    throw std::invalid_argument("PlaceRecogniser: keypoints and descriptors differ in number");
  }
  places_.push_back(std::move(view));
  return static_cast<int>(places_.size()) - 1;
}

std::vector<PlaceMatch> PlaceRecogniser::propose(const Gist& now, int most,
                                                 const std::function<bool(int)>& may_be) const {
  std::vector<PlaceMatch> nearest;
  for (int place = 0; std::cmp_less(place, places_.size()); ++place) {
    if (may_be && !may_be(place)) continue;
    nearest.push_back({.place = place, .gist_distance = gist_distance(now, view(place).gist)});
  }
  std::ranges::stable_sort(nearest, {}, &PlaceMatch::gist_distance);
  if (std::cmp_greater(nearest.size(), most)) nearest.resize(static_cast<std::size_t>(most));
  return nearest;
}

void PlaceRecogniser::compare(std::span<const Keypoint> keypoints, PlaceMatch& match) {
  const LandmarkView& known = view(match.place).view;
  if (known.keypoints.empty()) return;
  // One at a time: neighbours have nearly all in common, which must not count against them.
  const int number = recogniser_.add(match.place, known);
  const std::vector<Recognition>& found = recogniser_.recognise(keypoints);
  if (!found.empty()) {
    match.evidence =
        std::max(0.0, -log10_expected_of(found[0].score, settings_.matching.most_chance));
    match.inliers = found[0].inliers;
    match.scale = found[0].scale;
  }
  recogniser_.remove(number);
}

void PlaceRecogniser::add_neighbours(const Gist& now, const std::function<bool(int)>& may_be,
                                     const std::function<bool(int, int)>& same,
                                     std::vector<PlaceMatch>& matches) const {
  const int best = matches.front().place;
  const auto is_new = [&](int place) {
    const bool near = same(place, best) && (!may_be || may_be(place));
    return near && std::ranges::find(matches, place, &PlaceMatch::place) == matches.end();
  };
  for (const PlaceMatch& match : propose(now, settings_.most_neighbours, is_new)) {
    matches.push_back(match);
  }
}

void PlaceRecogniser::judge(const std::function<bool(int, int)>& same, PlaceAnswer& answer) const {
  const PlaceMatch& best = answer.matches.front();
  const auto other = std::ranges::find_if(answer.matches, [&](const PlaceMatch& match) {
    return match.place != best.place && !(same && same(match.place, best.place));
  });
  double ratio = best.evidence / settings_.least_evidence;
  const bool enough = ratio >= 1.0;
  if (other != answer.matches.end()) {
    answer.other = static_cast<int>(other - answer.matches.begin());
    if (other->evidence > 0.0) {
      ratio = std::min(ratio, best.evidence / other->evidence / settings_.least_lead);
    }
  }
  answer.confidence = confidence_of(ratio);
  answer.verdict = !enough        ? PlaceVerdict::nothing_agrees
                   : ratio >= 1.0 ? PlaceVerdict::known
                                  : PlaceVerdict::ambiguous;
}

PlaceAnswer PlaceRecogniser::find(const PlaceView& now, const std::function<bool(int)>& may_be,
                                  const std::function<bool(int, int)>& same) {
  PlaceAnswer answer;
  answer.matches = propose(now.gist, settings_.proposals, may_be);
  if (answer.matches.empty()) return answer;
  const std::vector<Keypoint> keypoints = keypoints_of(now.view);
  for (PlaceMatch& match : answer.matches) compare(keypoints, match);
  std::ranges::stable_sort(answer.matches, std::greater<>(), &PlaceMatch::evidence);
  if (same && answer.matches.front().evidence > 0.0) {
    const std::size_t compared = answer.matches.size();
    add_neighbours(now.gist, may_be, same, answer.matches);
    for (std::size_t k = compared; k < answer.matches.size(); ++k) {
      compare(keypoints, answer.matches[k]);
    }
    std::ranges::stable_sort(answer.matches, std::greater<>(), &PlaceMatch::evidence);
  }
  judge(same, answer);
  return answer;
}

const char* word_of(PlaceVerdict verdict) {
  switch (verdict) {
    case PlaceVerdict::known:
      return "known";
    case PlaceVerdict::ambiguous:
      return "ambiguous";
    case PlaceVerdict::nothing_agrees:
      return "nothing agrees";
    case PlaceVerdict::nothing_known:
      return "nothing known";
  }
  return "";
}

}  // namespace striate::perception
