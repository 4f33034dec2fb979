#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "striate/agent/cognitive_cycle.hpp"

/// Short-term memory at one moment, to be looked at: as JSON.
namespace striate::agent {

/// What short-term memory holds after a cycle: the body, what was last decided, the corridor, the
/// polar map (72 sectors from straight back over the left side, ahead and the right side; rings
/// from near to far; '#' stands, 'o' moves, '.' free, ' ' unknown), salient regions, landmarks in
/// mind, and the last commands, newest first.
[[nodiscard]] nlohmann::ordered_json memory_state(const CognitiveCycle& cycle,
                                                  const tasks::Executive& executive,
                                                  std::uint64_t number);

/// @throws UserError where the file is no such state
[[nodiscard]] nlohmann::ordered_json read_memory_state(const std::string& file);

}  // namespace striate::agent
