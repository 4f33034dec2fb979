#include "striate/memory/short_term/familiar_landmarks.hpp"

#include <algorithm>
#include <cmath>

namespace striate::memory {
namespace {

// By hand: activation changes over minutes; a landmark stays in sight as long.
constexpr Duration kOrderEvery = std::chrono::seconds(2);
constexpr double kNear_m = 6.0;  ///< farther ones are not expected: the map's window ends at 6.4 m
/// Where nothing says how high a landmark is, by hand: on the floor, on a table or on a wall.
constexpr double kSomewhere_m = 0.7;
constexpr double kSomewhereHalf_m = 0.5;

}  // namespace

std::vector<perception::KnownView> views_of(const LandmarkKnowledge& knowledge) {
  std::vector<perception::KnownView> views;
  for (std::size_t k = 0; k < knowledge.landmarks.size(); ++k) {
    for (const perception::LandmarkView& view : knowledge.landmarks[k].views) {
      views.push_back({static_cast<int>(k), view});
    }
  }
  return views;
}

FamiliarLandmarks::FamiliarLandmarks(const LandmarkKnowledge& knowledge,
                                     const LongTermSettings& settings, std::string_view sought)
    : settings_(settings),
      routes_(knowledge.routes),
      operating_start_s_(knowledge.operating_start_s),
      learning_(settings) {
  known_.reserve(knowledge.landmarks.size());
  int views = 0;
  for (const LandmarkModel& model : knowledge.landmarks) {
    KnownLandmark& known = known_.emplace_back();
    known.record = model.record;
    known.record.history.recent_s.reserve(UseHistory::kKept + 1);
    for (std::size_t k = 0; k < model.views.size(); ++k) known.views.push_back(views++);
    by_activation_.push_back(known_.size() - 1);
    if (known.record.name == sought) goal_ = known.record.id;
  }
  situation_.in_sight.reserve(LandmarkMemory::kCapacity);
  expected_.reserve(LandmarkMemory::kCapacity);
}

perception::LandmarkExpectations FamiliarLandmarks::expectations(const ShortTermMemory& memory,
                                                                 const Pose2& at) {
  if (known_.empty()) return {};
  if (!ordered_ || memory.now() - *ordered_ >= kOrderEvery) {
    ordered_ = memory.now();
    order_by_activation(memory);
  }
  expected_.clear();
  for (const std::size_t k : by_activation_) {
    const LandmarkInMind* mind = memory.landmarks().find(known_[k].record.id);
    if (mind == nullptr || !mind->place_known) continue;
    const Point2 here = inverse_transform(at, mind->place);
    if (std::hypot(here.x_m, here.y_m) > kNear_m) continue;
    const std::optional<double> height_m = known_[k].height_m;
    perception::LandmarkExpectation& expected = expected_.emplace_back();
    expected.landmark = static_cast<int>(k);
    expected.place = {here.x_m, here.y_m, height_m.value_or(kSomewhere_m)};
    if (!height_m) expected.half_m = kSomewhereHalf_m;
  }
  return {order_, expected_};
}

/// A = B + spread + ln(s / (1 - s)): what is most active is looked for first.
void FamiliarLandmarks::order_by_activation(const ShortTermMemory& memory) {
  situation_.now_s = operating_start_s_ + to_seconds(memory.now());
  situation_.goal = goal_;
  situation_.in_sight.clear();
  for (const LandmarkInMind& entry : memory.landmarks().all()) {
    const bool in_sight = entry.landmark != 0 && entry.sightings > 0 && entry.confirmed &&
                          memory.now() - entry.last_seen <= kOrderEvery;
    if (in_sight) situation_.in_sight.push_back(entry.landmark);
  }
  for (KnownLandmark& known : known_) {
    known.activation = activation_of(known.record, situation_, routes_, settings_).total();
  }
  std::ranges::sort(by_activation_, [&](std::size_t a, std::size_t b) {
    const double first = known_[a].activation, second = known_[b].activation;
    return first != second ? first > second : a < b;
  });
  order_.clear();
  for (const std::size_t k : by_activation_) {
    order_.insert(order_.end(), known_[k].views.begin(), known_[k].views.end());
  }
}

const Recognised& FamiliarLandmarks::recognised(const perception::Percept& percept,
                                                const Senses& senses,
                                                const ShortTermMemory& memory) {
  recognised_.sightings.clear();
  recognised_.lessons.clear();
  if (known_.empty() || !percept.valid) return recognised_;
  for (const perception::Recognition& found : percept.recognitions) {
    KnownLandmark& known = known_.at(static_cast<std::size_t>(found.landmark));
    if (std::isfinite(found.distance_m)) known.height_m = found.height_m;
    const LandmarkSighting& sighting = recognised_.sightings.emplace_back(LandmarkSighting{
        known.record.id, known.record.name, percept.stamp, found.score, found.bearing_rad,
        found.distance_m, percept.disparity.focal_px * percept.disparity.baseline_m});
    learning_->found(known.record.id);
    if (memory.confirms(sighting)) strengthen(known, found, senses);
  }
  const Point2 here{senses.odometry.pose.x_m, senses.odometry.pose.y_m};
  for (const perception::ExpectedLook& look : percept.expected) {
    if (look.result != perception::LookResult::missed) continue;
    weaken(known_.at(static_cast<std::size_t>(look.landmark)), here);
  }
  return recognised_;
}

void FamiliarLandmarks::strengthen(KnownLandmark& known, const perception::Recognition& found,
                                   const Senses& senses) {
  const Point2 here{senses.odometry.pose.x_m, senses.odometry.pose.y_m};
  if (!learning_->seen(known.record.id, here)) return;
  note_use(known.record.history, operating_start_s_ + to_seconds(senses.now));
  known.record.strength = consolidated(known.record.strength, settings_);
  recognised_.lessons.push_back({LandmarkLesson::Kind::recognised, known.record.id,
                                 known.record.name, found.bearing_rad, found.distance_m});
}

void FamiliarLandmarks::weaken(KnownLandmark& known, const Point2& here) {
  if (!learning_->missed(known.record.id, here)) return;
  known.record.strength = enfeebled(known.record.strength, settings_);
  recognised_.lessons.push_back(
      {LandmarkLesson::Kind::missed, known.record.id, known.record.name, 0.0, 0.0});
}

}  // namespace striate::memory
