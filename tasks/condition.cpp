#include "tasks/condition.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace striate {
namespace {

using config::Unit;

/// Holds from the moment when a figure of memory, counted from the start of the action, has grown
/// to the limit.
template <class Figure>
class GrownBy final : public Condition {
 public:
  explicit GrownBy(double limit) : limit_(limit) {}
  void start(const ShortTermMemory& memory) override { begin_ = Figure::of(memory); }
  [[nodiscard]] bool holds(const ShortTermMemory& memory) const override {
    return Figure::of(memory) - begin_ >= limit_;
  }

 private:
  double limit_;
  double begin_ = 0.0;
};

/// Holds while a figure of memory is at least (or at most) the limit.
template <class Figure, bool kAtLeast>
class Compared final : public Condition {
 public:
  explicit Compared(double limit) : limit_(limit) {}
  [[nodiscard]] bool holds(const ShortTermMemory& memory) const override {
    return kAtLeast ? Figure::of(memory) >= limit_ : Figure::of(memory) <= limit_;
  }

 private:
  double limit_;
};

struct Travelled {
  static double of(const ShortTermMemory& memory) { return memory.distance_travelled_m(); }
};
struct ProgressMade {
  static double of(const ShortTermMemory& memory) { return memory.progress_m(); }
};
struct Time {
  static double of(const ShortTermMemory& memory) { return to_seconds(memory.now()); }
};
struct Light {
  static double of(const ShortTermMemory& memory) { return memory.light_level(); }
};

template <class Kind>
std::unique_ptr<Condition> make(double value) {
  return std::make_unique<Kind>(value);
}

}  // namespace

const std::vector<ConditionEntry>& condition_registry() {
  static const std::vector<ConditionEntry> registry = {
      {"travelled",
       "driven so far since the action began, by odometry",
       Unit::length,
       {0.0, 100000.0},
       make<GrownBy<Travelled>>},
      {"progress",
       "got on along the corridor's axis since the mission began",
       Unit::length,
       {-100000.0, 100000.0},
       make<Compared<ProgressMade, true>>},
      {"after", "time since the action began", Unit::duration, {0.0, 86400.0}, make<GrownBy<Time>>},
      {"light_below",
       "the picture is darker than this",
       Unit::fraction,
       {0.0, 1.0},
       make<Compared<Light, false>>},
      {"light_above",
       "the picture is brighter than this",
       Unit::fraction,
       {0.0, 1.0},
       make<Compared<Light, true>>},
  };
  return registry;
}

std::unique_ptr<Condition> read_condition(const config::Node& node, config::Mistakes& mistakes) {
  if (node.kind != config::Node::Kind::map || node.entries.size() != 1) {
    mistakes.add(node.place,
                 fmt::format("a condition must be one 'name: value', but is {}", node.describe()),
                 "write {travelled: 58 m}");
    return nullptr;
  }
  const config::Node::Entry& entry = node.entries.front();
  const auto& registry = condition_registry();
  const auto found = std::find_if(registry.begin(), registry.end(),
                                  [&](const ConditionEntry& e) { return e.name == entry.key; });
  if (found == registry.end()) {
    std::vector<std::string> names;
    names.reserve(registry.size());
    for (const ConditionEntry& known : registry) names.push_back(known.name);
    std::string hint = config::suggest(entry.key, names);
    if (hint.empty()) hint = fmt::format("known: {}", fmt::join(names, ", "));
    mistakes.add(entry.key_place, fmt::format("unknown condition '{}'", entry.key), hint);
    return nullptr;
  }
  const auto value = config::read_quantity(entry.value, found->unit, found->range, mistakes);
  return value ? found->make(*value) : nullptr;
}

}  // namespace striate
