#include "striate/memory/long_term/row_copier.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include "striate/memory/long_term/memory_errors.hpp"
#include "striate/memory/long_term/statement_use.hpp"

namespace striate::memory {
namespace {

std::string joined(const std::vector<std::string>& words, const char* after = "") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word + after;
  return text;
}

std::vector<std::string> columns_of(SQLite::Database& database, const std::string& table) {
  std::vector<std::string> columns;
  SQLite::Statement info(database, "SELECT name FROM pragma_table_info(?)");
  info.bind(1, table);
  while (info.executeStep()) columns.push_back(info.getColumn(0).getString());
  return columns;
}

std::string places(std::size_t count) {
  return joined(std::vector<std::string>(count, "?"));
}

std::string neighbour(const std::string& table, const std::vector<std::string>& keys,
                      const char* relation, const char* order) {
  return fmt::format("SELECT {0} FROM {1} WHERE ({0}) {2} ({3}) ORDER BY {4} LIMIT 1", joined(keys),
                     table, relation, places(keys.size()), joined(keys, order));
}

}  // namespace

RowCopier::RowCopier(SQLite::Database& from, SQLite::Database& to, const std::string& table,
                     const std::vector<std::string>& keys)
    : two_(keys.size() == 2),
      next_(from, neighbour(table, keys, ">", " ASC")),
      previous_(from, neighbour(table, keys, "<", " DESC")),
      read_(from, fmt::format("SELECT {} FROM {} WHERE ({}) = ({})", joined(columns_of(to, table)),
                              table, joined(keys), places(keys.size()))),
      insert_(to,
              fmt::format("INSERT INTO {} ({}) VALUES ({})", table, joined(columns_of(to, table)),
                          places(columns_of(to, table).size()))) {}

void RowCopier::bind(SQLite::Statement& statement, const RowKey& key) const {
  statement.bind(1, key.first);
  if (two_) statement.bind(2, key.second);
}

RowFound RowCopier::step(SQLite::Statement& statement, RowKey& key, bool up) const {
  try {
    const StatementUse use(statement);
    bind(statement, key);
    if (!statement.executeStep()) return RowFound::none;
    RowKey found{statement.getColumn(0).getInt64(), 0};
    if (two_) found.second = statement.getColumn(1).getInt64();
    // What is left of a page may hold any number: to go back would be to go round for ever.
    if (up ? found <= key : found >= key) return RowFound::unreadable;
    key = found;
    return RowFound::row;
  } catch (const SQLite::Exception& error) {
    if (!is_damage(error)) throw;
    return RowFound::unreadable;
  }
}

RowFound RowCopier::copy(const RowKey& key) {
  try {
    const StatementUse use(read_);
    bind(read_, key);
    if (!read_.executeStep()) return RowFound::none;
    return insert();
  } catch (const SQLite::Exception& error) {
    if (!is_damage(error)) throw;
    return RowFound::unreadable;
  }
}

RowFound RowCopier::insert() {
  const StatementUse use(insert_);
  for (int i = 0; i < read_.getColumnCount(); ++i) {
    const SQLite::Column value = read_.getColumn(i);
    if (value.isInteger()) {
      insert_.bind(i + 1, value.getInt64());
    } else if (value.isFloat()) {
      insert_.bind(i + 1, value.getDouble());
    } else if (value.isText()) {
      insert_.bind(i + 1, value.getString());
    } else if (value.isBlob()) {
      insert_.bind(i + 1, value.getBlob(), value.getBytes());
    }
  }
  try {
    insert_.exec();
  } catch (const SQLite::Exception& error) {
    if ((error.getErrorCode() & kPrimaryCode) != SQLITE_CONSTRAINT) throw;
    return RowFound::unreadable;
  }
  ++copied_;
  return RowFound::row;
}

}  // namespace striate::memory
