#include "striate/perception/recognition/recogniser.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "striate/base/user_error.hpp"

namespace striate::perception {
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

void check_recognition(const RecognitionSettings& s) {
  auto bits = [](int limit) { return limit >= 1 && limit <= 257; };
  if (!bits(s.limit_bits) || !bits(s.paper_limit_bits)) {
    throw UserError("recognition: limits must be 1 .. 257 bits");
  }
  if (s.least_inliers < 3) throw UserError("recognition: 'least_inliers' must be at least 3");
  if (!(s.most_chance > 0.0)) throw UserError("recognition: 'most_chance' must be above 0");
}

KeypointFrame place_of(const ViewKeypoint& point) {
  return {point.x_px, point.y_px, point.size_px, point.angle_rad};
}

/// Where the view's frame and centre are in the image.
void write_pose(const Pose& pose, double width_px, double height_px, Recognition& to) {
  Box box;
  for (const double u : {-0.5, width_px - 0.5}) {
    for (const double v : {-0.5, height_px - 0.5}) box.add(pose.u_of(u, v), pose.v_of(u, v));
  }
  // The map is affine: the middle of the box is where the view's middle is.
  box.write(to);
  to.scale = pose.scale();
  to.angle_rad = pose.angle_rad();
}

}  // namespace

Recogniser::Recogniser(const RecognitionSettings& settings)
    : settings_(settings), consensus_(settings) {
  check_recognition(settings);
}

int Recogniser::add(int landmark, const LandmarkView& view) {
  if (view.descriptors.size() != view.keypoints.size()) {
    throw std::invalid_argument("a view needs as many keypoints as descriptors");
  }
  if (!(view.width_px > 0.0 && view.height_px > 0.0)) {
    throw std::invalid_argument("a view has no size");
  }
  auto free = std::ranges::find(views_, false, &View::in_use);
  if (free == views_.end()) free = views_.insert(views_.end(), View{});
  *free = {true, landmark, {}, {}, view.width_px, view.height_px, {}};
  ++change_;
  free->store.append(view.descriptors);
  for (const ViewKeypoint& point : view.keypoints) free->places.push_back(place_of(point));
  ++in_use_;
  return static_cast<int>(free - views_.begin());
}

void Recogniser::remove(int view) {
  View& removed = views_.at(static_cast<std::size_t>(view));
  if (!removed.in_use) throw std::out_of_range("Recogniser: no such view");
  removed = {};
  ++change_;
  --in_use_;
}

const std::vector<Recognition>& Recogniser::recognise(std::span<const Keypoint> keypoints) {
  begin(keypoints);
  for (std::size_t k = 0; k < views_.size(); ++k) look_for(static_cast<int>(k), keypoints);
  return sorted();
}

const std::vector<Recognition>& Recogniser::recognise(std::span<const Keypoint> keypoints,
                                                      std::span<const int> order,
                                                      const RecognitionBudget& budget,
                                                      std::span<const ExpectedPlace> expected) {
  begin(keypoints);
  expected_ = expected;
  for (const int view : order) {
    if (looked_at_ >= budget.most_views) break;
    if (looked_at_ > 0 && budget.goes_on && !budget.goes_on()) break;
    look_for(view, keypoints);
  }
  return sorted();
}

void Recogniser::begin(std::span<const Keypoint> keypoints) {
  expected_ = {};
  found_.clear();
  why_.clear();
  claims_.clear();
  looked_at_ = 0;
  queries_.clear();
  query_places_.clear();
  finest_px_ = std::numeric_limits<double>::infinity();
  for (const Keypoint& point : keypoints) {
    queries_.push_back(point.descriptor);
    query_places_.push_back(place_of(point));
    finest_px_ = std::min(finest_px_, point.wavelength_px);
  }
}

void Recogniser::look_for(int number, std::span<const Keypoint> keypoints) {
  View& view = views_.at(static_cast<std::size_t>(number));
  if (!view.in_use) return;
  ++looked_at_;
  Recognition found{.landmark = view.landmark, .view = number};
  const bool there = settings_.mode == RecognitionMode::paper
                         ? find_by_papers_rule(view, keypoints, found)
                         : find_pose(view, found);
  if (there) keep(found);
}

/// The paper's rule (its section on recognition): at least half of a view's descriptors have a
/// match with a Hamming distance below 48. Where they lie is not looked at.
bool Recogniser::find_by_papers_rule(const View& view, std::span<const Keypoint> keypoints,
                                     Recognition& found) {
  const auto limit = static_cast<std::uint32_t>(settings_.paper_limit_bits);
  nearest_.assign(view.store.size(), Match{0, 0, limit});
  for (const Match& match : search_.below(queries_, view.store, limit)) {
    if (match.distance_bits < nearest_[match.stored].distance_bits) nearest_[match.stored] = match;
  }
  Box box;
  for (const Match& match : nearest_) {
    if (match.distance_bits >= limit) continue;
    ++found.inliers;
    box.add(keypoints[match.query].u_px, keypoints[match.query].v_px);
  }
  found.matched_fraction = found.inliers / std::max(1.0, static_cast<double>(nearest_.size()));
  found.score = found.matched_fraction;
  if (found.inliers == 0 || found.matched_fraction < settings_.paper_share) return false;
  box.write(found);
  return true;
}

bool Recogniser::find_pose(View& view, Recognition& found) {
  find_pairs(view, queries_, query_places_);
  if (pairs_.size() < static_cast<std::size_t>(settings_.least_inliers)) return false;
  const Consensus consensus = consensus_.find(pairs_, view.width_px, view.height_px);
  if (consensus.inliers < settings_.least_inliers) return false;
  if (std::abs(consensus.pose.angle_rad()) > settings_.most_turn_rad) return false;
  compared_ = {pairs_under(pairs_, consensus.pose, view.width_px, view.height_px), consensus.pose,
               std::sqrt(view.width_px * view.height_px)};
  if (!is_enough(evidence(consensus_.agreeing(), compared_))) return false;
  const double all_inliers = consensus.inliers;
  found.inliers = keep_what_is_its_own(view);
  found.score = evidence(agreeing_, compared_);
  if (found.inliers < settings_.least_inliers || !is_enough(found.score)) return false;
  write_pose(consensus.pose, view.width_px, view.height_px, found);
  const double least = is_expected(found) ? settings_.least_share_expected : settings_.least_share;
  if (!agrees_all_over(view, consensus, found.inliers / all_inliers, least)) return false;
  found.matched_fraction = consensus.inliers / static_cast<double>(view.store.size());
  return true;
}

bool Recogniser::is_expected(const Recognition& found) const {
  return std::ranges::any_of(expected_, [&](const ExpectedPlace& one) {
    return one.landmark == found.landmark && one.box.contains({found.u_px, found.v_px});
  });
}

/// All pairs of a view and some descriptors with their places.
void Recogniser::find_pairs(const View& view, std::span<const Descriptor> descriptors,
                            std::span<const KeypointFrame> places) {
  const auto limit = static_cast<std::uint32_t>(settings_.limit_bits);
  const std::span<const Match> matches = search_.below(descriptors, view.store, limit);
  pairs_.clear();
  for (std::size_t from = 0, to = 0; from < matches.size(); from = to) {
    while (to < matches.size() && matches[to].query == matches[from].query) ++to;
    add_pair(view, places[matches[from].query], matches.subspan(from, to - from));
  }
}

/// The nearest keypoint of a view, if another place of the view is not nearly as near.
/// @param matches of the image's keypoint that is there
void Recogniser::add_pair(const View& view, const KeypointFrame& image_place,
                          std::span<const Match> matches) {
  const Match& first = *std::ranges::min_element(matches, {}, &Match::distance_bits);
  const KeypointFrame& place = view.places[first.stored];
  double second_bits = settings_.limit_bits;
  for (const Match& match : matches) {
    const KeypointFrame& other = view.places[match.stored];
    // The same place at a neighbouring scale or with its other angle is no rival.
    if (std::hypot(other.u_px - place.u_px, other.v_px - place.v_px) < place.size_px) continue;
    second_bits = std::min<double>(second_bits, match.distance_bits);
  }
  if (first.distance_bits >= settings_.ratio * second_bits) return;
  pairs_.push_back({place, image_place, static_cast<int>(first.stored)});
}

/// One landmark is reported once: by the view that most of it agrees with.
void Recogniser::keep(const Recognition& recognition) {
  const auto same = std::ranges::find(found_, recognition.landmark, &Recognition::landmark);
  const auto number = static_cast<std::size_t>(same - found_.begin());
  if (same == found_.end()) {
    found_.push_back(recognition);
    why_.push_back(compared_);
  } else {
    const bool better = settings_.mode == RecognitionMode::paper
                            ? recognition.matched_fraction > same->matched_fraction
                            : recognition.inliers > same->inliers;
    if (!better) return;
    *same = recognition;
    why_[number] = compared_;
  }
  if (settings_.mode == RecognitionMode::robust) claims_.put(number, agreeing_);
}

const std::vector<Recognition>& Recogniser::sorted() {
  if (settings_.mode == RecognitionMode::robust) leave_each_keypoint_to_one();
  // At most one entry a landmark, so that the order is total.
  std::ranges::sort(found_, [](const Recognition& a, const Recognition& b) {
    return a.inliers != b.inliers ? a.inliers > b.inliers : a.landmark < b.landmark;
  });
  return found_;
}

}  // namespace striate::perception
