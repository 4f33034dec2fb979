#pragma once

#include <string>
#include <utility>
#include <vector>

#include "striate/config/diagnostics.hpp"

namespace striate::config {

/// A value of a YAML file with its place. Maps keep the order of the file.
struct Node {
  enum class Kind { nothing, scalar, list, map };
  struct Entry;

  Kind kind = Kind::nothing;
  SourceLocation place;
  std::string text;            ///< of a scalar
  bool quoted = false;         ///< the scalar stood in quotes: never a number
  bool open = false;           ///< a scalar that is given later: fits every type for now
  std::vector<Node> items;     ///< of a list
  std::vector<Entry> entries;  ///< of a map

  [[nodiscard]] const Entry* find(const std::string& key) const;
  /// "a list", "a map", "'text'", "nothing": for messages.
  [[nodiscard]] std::string describe() const;
};

struct Node::Entry {
  std::string key;
  SourceLocation key_place;
  Node value;
};

}  // namespace striate::config
