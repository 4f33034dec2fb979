#pragma once

#include "striate/memory/localisation/localisation.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::memory {

/// What a memory knows of places: its landmarks that are not forgotten, routes, obstacle cells.
[[nodiscard]] MapKnowledge read_map(MemoryTables& tables);

/// Keeps what is new, within a transaction. What belongs to a landmark that was removed meanwhile
/// is left out.
void keep_map(MemoryTables& tables, const MapNews& news);

}  // namespace striate::memory
