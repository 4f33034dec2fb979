#pragma once

#include <string>
#include <vector>

#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::memory {

/// What came of merging another memory into one.
struct Merged {
  int sessions = 0;                  ///< that were not known
  int added = 0;                     ///< landmarks that were not known
  int joined = 0;                    ///< landmarks that both knew
  int views = 0;                     ///< views that came in
  int damaged = 0;                   ///< views of the other that were left out
  std::vector<std::string> remarks;  ///< names that changed, what could not be taken over

  [[nodiscard]] bool nothing_new() const { return sessions == 0 && added == 0 && views == 0; }
};

/// Takes all that `other` knows into `tables`, within a transaction. Landmarks of the same name, or
/// whose views show the same thing, become one with the views of both; routes go along. Positions
/// and the obstacle grid are taken over where there are none yet, or where two landmarks or more
/// lie alike on both maps, which says how the one map lies on the other; ours is kept where both
/// know. Sessions are recognised by when, by what and with which settings they were started: what
/// was merged before adds nothing, and of a memory that has grown since, only what is new.
[[nodiscard]] Merged merge(MemoryTables& tables, MemoryTables& other,
                           const LongTermSettings& settings);

}  // namespace striate::memory
