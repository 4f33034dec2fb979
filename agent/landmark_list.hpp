#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "striate/memory/long_term/activation.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::agent {

struct ListedLandmark {
  double activation = 0.0;
  memory::Landmark landmark;
};

/// The landmarks of a memory, the most active first, as they would be looked for now.
/// @param with_retired the forgotten ones, too
[[nodiscard]] std::vector<ListedLandmark> list_landmarks(memory::MemoryTables& tables,
                                                         bool with_retired,
                                                         const memory::LongTermSettings& settings);

/// As `striate memory --json list`: each with its activation.
[[nodiscard]] nlohmann::ordered_json to_json(const std::vector<ListedLandmark>& landmarks);

}  // namespace striate::agent
