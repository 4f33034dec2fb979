#include "striate/tasks/landmark_conditions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "striate/config/map_reader.hpp"
#include "striate/tasks/fault.hpp"

namespace striate::tasks {
namespace {

using config::Unit;

// By hand, as in behaviours/seek_landmark.cpp: so fresh is "in sight".
constexpr Duration kInSight = std::chrono::milliseconds(1000);

/// Recognised now, in looks enough.
class LandmarkSeen final : public Condition {
 public:
  LandmarkSeen(std::string name, double /*unused*/) : name_(std::move(name)) {}
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    return memory.landmarks().in_sight(name_, memory.now(), kInSight);
  }

 private:
  std::string name_;
};

/// Where it is, is known: from this run or from long-term memory.
class LandmarkKnown final : public Condition {
 public:
  LandmarkKnown(std::string name, double /*unused*/) : name_(std::move(name)) {}
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    const memory::LandmarkInMind* landmark = memory.landmarks().find(name_);
    return landmark != nullptr && landmark->place_known;
  }

 private:
  std::string name_;
};

class LandmarkWithin final : public Condition {
 public:
  LandmarkWithin(std::string name, double limit_m) : name_(std::move(name)), limit_m_(limit_m) {}
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    const memory::LandmarkInMind* landmark = memory.landmarks().find(name_);
    if (landmark == nullptr || !landmark->place_known) return false;
    const Pose2& here = memory.pose();
    return std::hypot(landmark->place.x_m - here.x_m, landmark->place.y_m - here.y_m) <= limit_m_;
  }

 private:
  std::string name_;
  double limit_m_;
};

template <class Kind>
std::unique_ptr<Condition> make_about(const std::string& landmark, double value) {
  return std::make_unique<Kind>(landmark, value);
}

}  // namespace

const std::vector<ConditionEntry>& landmark_conditions() {
  static const std::vector<ConditionEntry> entries = [] {
    std::vector<ConditionEntry> list(3);
    list[0].name = "landmark_seen";
    list[0].help = "the landmark is recognised now, in some looks in a row";
    list[0].example = "book";
    list[0].make_of = make_about<LandmarkSeen>;
    list[1].name = "landmark_known";
    list[1].help = "where the landmark is, is known: seen in this run or recalled";
    list[1].example = "book";
    list[1].make_of = make_about<LandmarkKnown>;
    list[1].standing = WhileStanding::stays;
    list[2].name = "landmark_within";
    list[2].help = "the robot is so near to the landmark's place, once that is known";
    list[2].unit = Unit::length;
    list[2].range = {0.0, 1000.0};
    list[2].example = "{landmark: book, distance: 1 m}";
    list[2].make_of = make_about<LandmarkWithin>;
    list[2].key = "distance";
    list[2].standing = WhileStanding::stays;
    return list;
  }();
  return entries;
}

std::unique_ptr<Condition> read_landmark_condition(const ConditionEntry& kind,
                                                   const config::Node::Entry& entry,
                                                   config::Diagnostics& diagnostics) {
  const config::Node& value = entry.value;
  if (kind.key.empty()) {
    if (value.kind == config::Node::Kind::scalar) return kind.make_of(value.text, 0.0);
    diagnostics.add(
        fault::bad_condition, value.place,
        fmt::format("'{}' must be a landmark's name, but is {}", kind.name, value.describe()),
        fmt::format("write {{{}: {}}}", kind.name, kind.example));
    return nullptr;
  }
  if (value.kind != config::Node::Kind::map) {
    diagnostics.add(fault::bad_condition, value.place,
                    fmt::format("'{}' must say which landmark and which {}, but is {}", kind.name,
                                kind.key, value.describe()),
                    fmt::format("write {{{}: {}}}", kind.name, kind.example));
    return nullptr;
  }
  std::string landmark;
  double limit = 0.0;
  const std::size_t before = diagnostics.count();
  config::MapReader map(value, kind.name, diagnostics);
  if (map.require("landmark")) map.text("landmark", landmark);
  if (map.require(kind.key)) map.number(kind.key, limit, kind.unit, kind.range);
  map.finish();
  return diagnostics.count() == before ? kind.make_of(landmark, limit) : nullptr;
}

}  // namespace striate::tasks
