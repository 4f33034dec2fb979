#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "striate/memory/long_term/memory_tables.hpp"

/// The long-term memory whole, as JSON: `striate memory export` and `import`.
namespace striate::app {

/// Everything that a memory holds; damaged views are left out and counted.
[[nodiscard]] nlohmann::ordered_json export_memory(memory::MemoryTables& tables);

/// Fills an empty memory with what `export_memory` wrote.
/// @throws UserError where the text is no such export; `file` names it in the sentence.
void import_memory(const std::string& text, const std::string& file, memory::MemoryTables& tables);

}  // namespace striate::app
