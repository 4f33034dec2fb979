#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "memory/long_term/activation.hpp"
#include "memory/long_term/memory_tables.hpp"

/// The long-term memory as JSON: for `--json`, and whole for `export` and `import`.
namespace striate {

/// Without views; bytes as in the file are only in `export_memory`.
[[nodiscard]] nlohmann::ordered_json to_json(const Landmark& landmark);
[[nodiscard]] nlohmann::ordered_json to_json(const StoredView& view);  ///< without its bytes
[[nodiscard]] nlohmann::ordered_json to_json(const Episode& episode);
[[nodiscard]] nlohmann::ordered_json to_json(const Session& session);
[[nodiscard]] nlohmann::ordered_json to_json(const Route& route);
[[nodiscard]] nlohmann::ordered_json to_json(const ObstacleCell& cell);

/// Two blanks of indentation and a line break at the end; what is not UTF-8 is replaced.
[[nodiscard]] std::string print_json(const nlohmann::ordered_json& json);

/// Everything that a memory holds; damaged views are left out and counted.
[[nodiscard]] nlohmann::ordered_json export_memory(MemoryTables& tables);

/// Fills an empty memory with what `export_memory` wrote.
/// @throws UserError where the text is no such export; `file` names it in the sentence.
void import_memory(const std::string& text, const std::string& file, MemoryTables& tables);

}  // namespace striate
