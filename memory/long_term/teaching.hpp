#pragma once

#include <string>
#include <vector>

#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/memory_tables.hpp"
#include "striate/memory/long_term/view_comparer.hpp"

namespace striate::memory {

/// What came of teaching.
struct Taught {
  bool is_new = false;    ///< else views were added to a landmark that was known
  bool restored = false;  ///< it was forgotten and is back
  int added = 0;          ///< views
  int merged = 0;  ///< views so like an old one that they were left out, or that took its place
  std::vector<std::string> remarks;  ///< looks like an old one, has little structure
};

/// Names are for people: 1 to 64 bytes, no control characters, no blank at either end.
/// @throws UserError
void check_landmark_name(const std::string& name);

/// Keeps views under a name, within a transaction of a session.
/// @throws UserError for a bad name or a view with too little structure to be recognised; then
/// nothing is to be kept.
[[nodiscard]] Taught teach(MemoryTables& tables, const Session& session, const std::string& name,
                           const std::vector<StoredView>& views, const LongTermSettings& settings);

/// The same view of the same thing: one of them is enough.
[[nodiscard]] bool are_alike(const StoredView& a, const StoredView& b, ViewComparer& comparer,
                             const LongTermSettings& settings);

/// Adds a view to a landmark. A view alike to an old one is left out; of too many views, of the two
/// most alike the one with fewer keypoints goes.
/// @return whether the landmark has one view more than before.
bool add_view(MemoryTables& tables, const StoredView& view, ViewComparer& comparer,
              const LongTermSettings& settings);

/// Takes back the views that the newest teaching session not yet undone has added here; teaching
/// that came in by merging is not touched. What the limit of views removed does not come back.
/// @return what was taken back, in a sentence. @throws UserError where there is nothing to undo.
[[nodiscard]] std::string undo_teaching(MemoryTables& tables);

}  // namespace striate::memory
