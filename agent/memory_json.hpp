#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "striate/memory/long_term/activation.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

/// The long-term memory as JSON: for `--json`, and part of `export`.
namespace striate::agent {

/// Without views.
[[nodiscard]] nlohmann::ordered_json to_json(const memory::Landmark& landmark);
[[nodiscard]] nlohmann::ordered_json to_json(
    const memory::StoredView& view);  ///< without its bytes
[[nodiscard]] nlohmann::ordered_json to_json(const memory::Episode& episode);
[[nodiscard]] nlohmann::ordered_json to_json(const memory::Session& session);
[[nodiscard]] nlohmann::ordered_json to_json(const memory::Route& route);
[[nodiscard]] nlohmann::ordered_json to_json(const memory::ObstacleCell& cell);

/// Whether it will be forgotten, and why, in words: "a person taught it, so it is not forgotten".
[[nodiscard]] std::string fate_of(const memory::Landmark& landmark, double now_s,
                                  const memory::LongTermSettings& settings);

/// Two blanks of indentation and a line break at the end; what is not UTF-8 is replaced.
[[nodiscard]] std::string print_json(const nlohmann::ordered_json& json);

}  // namespace striate::agent
