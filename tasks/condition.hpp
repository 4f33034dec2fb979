#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "striate/base/time.hpp"
#include "striate/config/quantity.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"

namespace striate::tasks {

/// A goal detector: looks at memory, never at the body.
class Condition {
 public:
  virtual ~Condition() = default;
  /// Called when the action that it belongs to starts.
  virtual void start(const memory::ShortTermMemory& /*memory*/) {}
  [[nodiscard]] virtual bool holds(const memory::ShortTermMemory& memory) const = 0;
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
  std::function<std::unique_ptr<Condition>(double value_si)> make{};
  /// Instead of `make`, where it is about a landmark; with `key` it takes a map of `landmark` and
  /// `key`, without it the landmark's name alone.
  std::function<std::unique_ptr<Condition>(const std::string& landmark, double value_si)> make_of{};
  std::string key{};
  /// Once it holds it goes on holding for as long as the robot stands: `pause_if` would never end.
  bool lasts_while_standing = false;
};

}  // namespace striate::tasks
