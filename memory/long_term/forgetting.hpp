#pragma once

#include <string>
#include <vector>

#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::memory {

/// Forgetting retires: the landmark is no longer looked for, all that is known of it stays, and it
/// can be restored. Each is called within a transaction.

/// Why it may be forgotten, in words: weak, inactive, not taught, not pinned. Empty: it may not.
[[nodiscard]] std::string why_forgettable(const Landmark& landmark, double now_s,
                                          const LongTermSettings& settings);

/// @throws UserError where there is no such landmark, with the nearest names, or it is forgotten
/// already.
void forget(MemoryTables& tables, const std::string& name, const std::string& why);

/// Brings it back and pins it: a person wants it, so it is not forgotten again by itself.
/// @throws UserError where there is no such landmark, or it is not forgotten.
void restore(MemoryTables& tables, const std::string& name);

struct PrunePlan {
  std::vector<Landmark> retire;  ///< with the reason in retired_why
  std::vector<Landmark> remove;  ///< retired long ago: for good
  int episodes = 0;              ///< the oldest, beyond what is kept
  [[nodiscard]] bool empty() const { return retire.empty() && remove.empty() && episodes == 0; }
};

/// From now on the landmark has another name, with all that is known of it: views, place, routes
/// and episodes. @throws UserError where there is none of that name, or `to` is taken or no name.
void rename(MemoryTables& tables, const std::string& name, const std::string& to);

[[nodiscard]] PrunePlan plan_prune(MemoryTables& tables, const LongTermSettings& settings);
void prune(MemoryTables& tables, const PrunePlan& plan, const LongTermSettings& settings);

/// The landmark of that name. @throws UserError naming those that sound like it.
[[nodiscard]] Landmark find_landmark(MemoryTables& tables, const std::string& name);

}  // namespace striate::memory
