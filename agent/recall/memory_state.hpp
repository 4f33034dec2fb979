#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "striate/agent/cognitive_cycle.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"

/// Short-term memory at one moment, to be looked at: as JSON.
namespace striate::agent {

/// What short-term memory holds after a cycle: the body, what was last decided, the corridor, the
/// polar map (72 sectors from straight back over the left side, ahead and the right side; rings
/// from near to far; '#' stands, 'o' moves, '.' free, ' ' unknown), salient regions, landmarks in
/// mind, and the last commands, newest first.
[[nodiscard]] nlohmann::ordered_json memory_state(const CognitiveCycle& cycle,
                                                  const tasks::Executive& executive,
                                                  std::uint64_t number);

/// Parts of it alone. A length that is not known is infinite here, and null in the whole.
[[nodiscard]] nlohmann::ordered_json corridor_state(const memory::ShortTermMemory& memory);
[[nodiscard]] nlohmann::ordered_json salient_regions_state(const memory::ShortTermMemory& memory);
[[nodiscard]] nlohmann::ordered_json landmarks_state(const memory::ShortTermMemory& memory);

/// @throws UserError where the file is no such state
[[nodiscard]] nlohmann::ordered_json read_memory_state(const std::string& file);

}  // namespace striate::agent
