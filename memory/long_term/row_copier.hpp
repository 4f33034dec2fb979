#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <string>
#include <vector>

namespace striate::memory {

/// What came of asking a damaged table for a row.
enum class RowFound { row, none, unreadable };

/// The key of a row: an id, or two numbers. Ordered as the table is.
struct RowKey {
  std::int64_t first = 0;
  std::int64_t second = 0;
  auto operator<=>(const RowKey&) const = default;
};

/// Finds rows of one table by key and copies them into the same table of another database, each by
/// itself, so that a row that cannot be read is told apart from one that is not there.
class RowCopier {
 public:
  /// @param keys the names of the key's one or two columns
  RowCopier(SQLite::Database& from, SQLite::Database& to, const std::string& table,
            const std::vector<std::string>& keys);

  /// The first row whose key is greater than `key`; it is put into `key`.
  RowFound next(RowKey& key) { return step(next_, key, true); }
  /// The last row whose key is smaller.
  RowFound previous(RowKey& key) { return step(previous_, key, false); }
  /// Copies the row with this key. A row that the other table's rules refuse is unreadable, too.
  /// @throws SQLite::Exception where the other database cannot be written
  RowFound copy(const RowKey& key);

  [[nodiscard]] std::int64_t copied() const { return copied_; }

 private:
  RowFound step(SQLite::Statement& statement, RowKey& key, bool up) const;
  void bind(SQLite::Statement& statement, const RowKey& key) const;
  RowFound insert();

  bool two_;
  SQLite::Statement next_, previous_, read_, insert_;
  std::int64_t copied_ = 0;
};

}  // namespace striate::memory
