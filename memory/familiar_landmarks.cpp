#include "memory/familiar_landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace striate {
namespace {

// By hand: activation changes over minutes; a landmark stays in sight as long.
constexpr Duration kOrderEvery = std::chrono::seconds(2);
constexpr double kNear_m = 6.0;  ///< farther ones are not expected: the map's window ends at 6.4 m
/// Where nothing says how high a landmark is, by hand: on the floor, on a table or on a wall.
constexpr double kSomewhere_m = 0.7;
constexpr double kSomewhereHalf_m = 0.5;

}  // namespace

FamiliarLandmarks::FamiliarLandmarks(LandmarkKnowledge knowledge, const LongTermSettings& settings)
    : settings_(settings),
      routes_(std::move(knowledge.routes)),
      operating_start_s_(knowledge.operating_start_s),
      learning_(settings) {
  known_.reserve(knowledge.landmarks.size());
  for (LandmarkModel& model : knowledge.landmarks) {
    Known& known = known_.emplace_back();
    known.record = std::move(model.record);
    known.record.history.recent_s.reserve(UseHistory::kKept + 1);
    known.views = std::move(model.views);
    by_activation_.push_back(known_.size() - 1);
  }
  situation_.in_sight.reserve(LandmarkMemory::kCapacity);
  expected_.reserve(LandmarkMemory::kCapacity);
}

void FamiliarLandmarks::hand_over(LandmarkFinder& finder) {
  for (std::size_t k = 0; k < known_.size(); ++k) {
    for (const LandmarkView& view : known_[k].views) {
      known_[k].numbers.push_back(finder.know(static_cast<int>(k), view));
    }
    known_[k].views.clear();
    known_[k].views.shrink_to_fit();
  }
}

void FamiliarLandmarks::seek(std::string_view name) {
  goal_ = 0;
  for (const Known& known : known_) {
    if (known.record.name == name) goal_ = known.record.id;
  }
  ordered_.reset();
}

void FamiliarLandmarks::guide(const ShortTermMemory& memory, const Pose2& at,
                              LandmarkFinder& finder) {
  if (known_.empty()) return;
  if (!ordered_ || memory.now() - *ordered_ >= kOrderEvery) {
    ordered_ = memory.now();
    order_by_activation(memory, finder);
  }
  expected_.clear();
  for (const std::size_t k : by_activation_) {
    const LandmarkInMind* mind = memory.landmarks().find(known_[k].record.id);
    if (mind == nullptr || !mind->place_known) continue;
    const Point2 here = to_inner(at, mind->place);
    if (std::hypot(here.x_m, here.y_m) > kNear_m) continue;
    const std::optional<double> height_m = known_[k].height_m;
    LandmarkExpectation& expected = expected_.emplace_back();
    expected.landmark = static_cast<int>(k);
    expected.place = {here.x_m, here.y_m, height_m.value_or(kSomewhere_m)};
    if (!height_m) expected.half_m = kSomewhereHalf_m;
  }
  finder.expect(expected_);
}

/// A = B + spread + ln(s / (1 - s)): what is most active is looked for first.
void FamiliarLandmarks::order_by_activation(const ShortTermMemory& memory, LandmarkFinder& finder) {
  situation_.now_s = operating_start_s_ + to_seconds(memory.now());
  situation_.goal = goal_;
  situation_.in_sight.clear();
  for (const LandmarkInMind& entry : memory.landmarks().all()) {
    const bool in_sight = entry.landmark != 0 && entry.sightings > 0 && entry.confirmed &&
                          memory.now() - entry.last_seen <= kOrderEvery;
    if (in_sight) situation_.in_sight.push_back(entry.landmark);
  }
  for (Known& known : known_) {
    known.activation = activation_of(known.record, situation_, routes_, settings_).total();
  }
  std::ranges::sort(by_activation_, [&](std::size_t a, std::size_t b) {
    const double first = known_[a].activation, second = known_[b].activation;
    return first != second ? first > second : a < b;
  });
  order_.clear();
  for (const std::size_t k : by_activation_) {
    order_.insert(order_.end(), known_[k].numbers.begin(), known_[k].numbers.end());
  }
  finder.look_for(order_);
}

const std::vector<LandmarkSighting>& FamiliarLandmarks::name(const Percept& percept) {
  sightings_.clear();
  if (known_.empty() || !percept.valid || named_ == percept.stamp) return sightings_;
  named_ = percept.stamp;
  to_learn_ = true;
  for (const Recognition& found : percept.recognitions) {
    Known& known = known_.at(static_cast<std::size_t>(found.landmark));
    if (std::isfinite(found.distance_m)) known.height_m = found.height_m;
    sightings_.push_back({known.record.id, known.record.name, percept.stamp, found.score,
                          found.bearing_rad, found.distance_m});
  }
  return sightings_;
}

const std::vector<LandmarkLesson>& FamiliarLandmarks::learn(const Percept& percept,
                                                            const ShortTermMemory& memory) {
  lessons_.clear();
  if (!std::exchange(to_learn_, false)) return lessons_;
  const Point2 here{memory.pose().x_m, memory.pose().y_m};
  for (const Recognition& found : percept.recognitions) {
    Known& known = known_.at(static_cast<std::size_t>(found.landmark));
    learning_->found(known.record.id);
    if (!memory.landmarks().confirmed_by(known.record.id, percept.stamp)) continue;
    if (!learning_->seen(known.record.id, here)) continue;
    note_use(known.record.history, operating_start_s_ + to_seconds(memory.now()));
    known.record.strength = consolidated(known.record.strength, settings_);
    lessons_.push_back({LandmarkLesson::Kind::recognised, known.record.id, known.record.name,
                        found.bearing_rad, found.distance_m});
  }
  for (const ExpectedLook& look : percept.expected) {
    Known& known = known_.at(static_cast<std::size_t>(look.landmark));
    if (look.result != LookResult::missed || !learning_->missed(known.record.id, here)) continue;
    known.record.strength = enfeebled(known.record.strength, settings_);
    lessons_.push_back(
        {LandmarkLesson::Kind::missed, known.record.id, known.record.name, 0.0, 0.0});
  }
  return lessons_;
}

}  // namespace striate
