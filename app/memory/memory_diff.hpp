#pragma once

#include <string>
#include <vector>

#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::app {

/// One landmark that two memories do not know alike.
struct Difference {
  std::string name;
  std::string what;  ///< "only in A", "only in B", or what is not the same: "views 2 / 3, strength"
};

/// Compares landmarks by name: kind, strength, uses, position, state, and the views by content.
[[nodiscard]] std::vector<Difference> differences(memory::MemoryTables& a, memory::MemoryTables& b);

}  // namespace striate::app
