#pragma once

#include <string>
#include <utility>
#include <vector>

#include "striate/config/quantity.hpp"

namespace striate::config {

/// Takes the entries of one map by name, each with its type, unit and range, and at the end
/// reports every key that nobody asked for. Absent keys leave the target as it is.
class MapReader {
 public:
  /// Adds a mistake if `node` is no map. `what` names it in messages: "a door", "world".
  MapReader(const Node& node, std::string what, Diagnostics& diagnostics);
  ~MapReader() = default;
  MapReader(const MapReader&) = delete;
  MapReader& operator=(const MapReader&) = delete;

  bool number(const std::string& key, double& target, Unit unit, Range range);
  bool integer(const std::string& key, int& target, Range range);
  bool flag(const std::string& key, bool& target);
  bool text(const std::string& key, std::string& target);
  /// One of `names`; `target` becomes its index.
  bool choice(const std::string& key, int& target, const std::vector<std::string>& names);
  /// A list of exactly `targets.size()` quantities of one unit: [9.0 m, 0.5 m].
  bool numbers(const std::string& key, const std::vector<double*>& targets, Unit unit, Range range);
  /// The raw value of a key, or nullptr; counts as asked for.
  const Node* raw(const std::string& key);
  /// A key without effect any more: a warning where it is given.
  void retired(const std::string& key, const std::string& note);
  /// A key that has another name now: the old one is still read, with a warning. Call it before the
  /// key is asked for.
  void renamed(const std::string& was, const std::string& now);
  /// Says that a missing key is a mistake; returns whether it is there.
  bool require(const std::string& key);

  [[nodiscard]] const Node& node() const { return node_; }
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }

  /// Reports unknown keys with the nearest known one. Call once, last.
  void finish();

 private:
  const Node& node_;
  std::string what_;
  Diagnostics& diagnostics_;
  std::vector<std::string> known_;
  std::vector<std::pair<std::string, std::string>> renamed_;  ///< old name, new name
};

}  // namespace striate::config
