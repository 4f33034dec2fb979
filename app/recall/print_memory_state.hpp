#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace striate::app {

/// What `agent::memory_state` says, for a person, in lines of at most `width` letters.
/// @throws nlohmann::json::exception where it is no such state
[[nodiscard]] std::string print_memory_state(const nlohmann::ordered_json& state, int width);

}  // namespace striate::app
