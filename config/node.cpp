#include "striate/config/node.hpp"

#include <fmt/format.h>

namespace striate::config {

const Node::Entry* Node::find(const std::string& key) const {
  for (const Entry& entry : entries) {
    if (entry.key == key) return &entry;
  }
  return nullptr;
}

std::string Node::describe() const {
  switch (kind) {
    case Kind::scalar:
      return fmt::format("'{}'", text);
    case Kind::list:
      return "a list";
    case Kind::map:
      return "a map";
    case Kind::nothing:
      break;
  }
  return "nothing";
}

}  // namespace striate::config
