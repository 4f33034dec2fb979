#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "striate/memory/long_term/memory_tables.hpp"

/// The long-term memory whole, as JSON: `striate memory export` and `import`.
namespace striate::app {

/// Version of the exported file; a reader refuses others.
constexpr int kMemoryExport = 1;

/// Everything that a memory holds; damaged views are left out and counted.
[[nodiscard]] nlohmann::ordered_json export_memory(memory::MemoryTables& tables);

/// The same of a file that may be damaged: every row that can be read, and in `rows_left_out` a
/// sentence for each table of which something cannot.
/// @throws UserError where the file cannot be read, or nothing tells that it is a memory
[[nodiscard]] nlohmann::ordered_json export_readable(const std::string& file);

/// Fills an empty memory with what `export_memory` wrote.
/// @throws UserError where the text is no such export; `file` names it in the sentence.
void import_memory(const std::string& text, const std::string& file, memory::MemoryTables& tables);

}  // namespace striate::app
