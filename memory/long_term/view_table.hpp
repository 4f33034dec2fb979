#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

class StatementUse;

/// The table `landmark_view`. All errors are SQLite::Exception.
class ViewTable {
 public:
  explicit ViewTable(SQLite::Database& database);

  /// @return its id. The view has at least one keypoint and as many descriptors.
  std::int64_t add(const StoredView& view);
  /// All views of a landmark with their images, the oldest first. Damaged ones say so; a
  /// damaged image is empty.
  [[nodiscard]] std::vector<StoredView> of(std::int64_t landmark);
  /// Hands every view of every landmark that is not retired to `take`, without its image, in the
  /// order of the file. The view is reused for the next one. Damaged ones are handed over too.
  /// @param last none with a higher number
  void for_each(const std::function<void(const StoredView&)>& take,
                std::int64_t last = std::numeric_limits<std::int64_t>::max());
  void remove(std::int64_t id);
  /// @return how many views a session added and are still there.
  [[nodiscard]] int count_of_session(std::int64_t session);
  /// Removes what a session added, and landmarks that have no view left.
  void remove_of_session(std::int64_t session);

 private:
  static void read(const StatementUse& row, StoredView& view, bool with_image);

  SQLite::Database& database_;
  SQLite::Statement add_, of_, each_, remove_, count_of_session_, remove_of_session_, remove_empty_;
};

}  // namespace striate::memory
