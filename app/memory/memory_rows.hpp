#pragma once

#include <nlohmann/json.hpp>

#include "striate/memory/long_term/memory_tables.hpp"

/// Rows of a memory, read from its export.
namespace striate::app {

/// Each throws what the JSON library, or a number out of its range, says; the caller tells where.
[[nodiscard]] memory::Session session_of(const nlohmann::ordered_json& json);

[[nodiscard]] memory::Landmark landmark_of(const nlohmann::ordered_json& json);

[[nodiscard]] memory::StoredView view_of(const nlohmann::ordered_json& json);

[[nodiscard]] memory::Episode episode_of(const nlohmann::ordered_json& json);

}  // namespace striate::app
