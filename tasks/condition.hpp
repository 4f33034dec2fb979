#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "config/quantity.hpp"
#include "memory/short_term_memory.hpp"

namespace striate {

/// A goal detector: looks at memory, never at the body.
class Condition {
 public:
  virtual ~Condition() = default;
  /// Called when the action that it belongs to starts.
  virtual void start(const ShortTermMemory& /*memory*/) {}
  [[nodiscard]] virtual bool holds(const ShortTermMemory& memory) const = 0;
};

/// One kind of condition that scripts can name in `until`, `only_if`, `unless` and `always`, e.g.
/// `{travelled: 58 m}`, `{landmark_seen: book}`, `{landmark_within: {landmark: book, distance: 1
/// m}}`.
struct ConditionEntry {
  std::string name;
  std::string help;
  config::Unit unit;
  config::Range range;
  std::string example;  ///< a value: "58 m"
  std::unique_ptr<Condition> (*make)(double value_si) = nullptr;
  /// Instead of `make`, where it is about a landmark; with `key` it takes a map of `landmark` and
  /// `key`, without it the landmark's name alone.
  std::unique_ptr<Condition> (*make_of)(const std::string& landmark, double value_si) = nullptr;
  std::string key{};
};

[[nodiscard]] const std::vector<ConditionEntry>& condition_registry();

/// Reads `{name: value}`; nullptr with mistakes added where that fails.
std::unique_ptr<Condition> read_condition(const config::Node& node, config::Mistakes& mistakes);

/// "name: value" as written, for people; empty where the node is no condition.
[[nodiscard]] std::string condition_text(const config::Node& node);

}  // namespace striate
