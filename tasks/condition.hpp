#pragma once

#include <cstdint>
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

/// What becomes of a condition while the robot stands, and time alone passes.
enum class WhileStanding : std::uint8_t {
  changes,  ///< it may come and go
  comes,    ///< it begins to hold in time, and goes on holding
  stays,    ///< it is as it was when the robot came to stand
};

/// One kind of condition that scripts can name in `until`, `only_if`, `unless` and `always`, e.g.
/// `{travelled: 58 m}`, `{landmark_seen: book}`, `{landmark_within: {landmark: book, distance: 1
/// m}}`. `all`, `any` and `not` join them (joined_conditions.hpp).
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
  /// The robot stands while a task pauses: `pause_if` of what comes or stays would never end.
  WhileStanding standing = WhileStanding::changes;
};

}  // namespace striate::tasks
