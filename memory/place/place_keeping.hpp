#pragma once

#include "memory/long_term/memory_tables.hpp"
#include "memory/place/place_memory.hpp"

namespace striate {

/// What a memory knows of places: its landmarks that are not forgotten, routes, obstacle cells.
[[nodiscard]] PlaceKnowledge read_places(MemoryTables& tables);

/// Keeps what is new, within a transaction. What belongs to a landmark that was removed meanwhile
/// is left out.
void keep_places(MemoryTables& tables, const PlaceNews& news);

}  // namespace striate
