#pragma once

#include <string>
#include <utility>
#include <vector>

#include "config/mistakes.hpp"

namespace striate::config {

/// A value of a YAML file with its place. Maps keep the order of the file.
struct Node {
  enum class Kind { nothing, scalar, list, map };
  struct Entry;

  Kind kind = Kind::nothing;
  Place place;
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
  Place key_place;
  Node value;
};

/// Reads YAML text strictly: duplicate keys, anchors, aliases, tags, several documents, more than
/// 1 MB, 32 levels or 20,000 values are mistakes. Returns the root, of kind nothing if unreadable.
Node parse_yaml(const std::string& text, Mistakes& mistakes);

/// Reads a file; adds a mistake where it cannot be read.
Node load_yaml(Mistakes& mistakes);

}  // namespace striate::config
