#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/cognitive_cycle.hpp"

/// Short-term memory at one moment, to be looked at: as JSON, and from that as text.
namespace striate {

/// What short-term memory holds after a cycle: the body, what was last decided, the corridor, the
/// polar map (72 sectors from straight back over the left side, ahead and the right side; rings
/// from near to far; '#' stands, 'o' moves, '.' free, ' ' unknown), salient regions, landmarks in
/// mind, and the last commands, newest first.
[[nodiscard]] nlohmann::ordered_json memory_state(const CognitiveCycle& cycle,
                                                  const Executive& executive, std::uint64_t number);

/// The same for a person, in lines of at most `width` letters.
/// @throws nlohmann::json::exception where it is no such state
[[nodiscard]] std::string print_memory_state(const nlohmann::ordered_json& state, int width);

/// @throws UserError where the file is no such state
[[nodiscard]] nlohmann::ordered_json read_memory_state(const std::string& file);

}  // namespace striate
