#include "striate/memory/long_term/memory_file.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

#include "striate/base/shell_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_errors.hpp"

namespace striate::memory {
namespace {

/// A file that nobody can be writing to, because its folder is read-only and no log lies beside it.
std::string as_immutable(const std::string& path) {
  std::string uri = "file:";
  for (const char letter : path) {
    if (letter == '?' || letter == '#' || letter == '%') {
      uri += fmt::format("%{:02X}", static_cast<int>(letter));
    } else {
      uri += letter;
    }
  }
  return uri + "?immutable=1";
}

/// SQLite takes some names for a database that is kept nowhere, or reads options out of them; and a
/// pipe or a device keeps nothing either.
void check_path(const std::string& path) {
  if (path.empty()) {
    throw UserError("the name of the memory is empty\n    name a file, such as home.db");
  }
  if (path == ":memory:" || path.rfind("file:", 0) == 0) {
    throw UserError(
        fmt::format("{}: SQLite takes this name for something else than a file, and "
                    "nothing would be kept\n    write ./{} if that is its name",
                    path, path));
  }
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (std::filesystem::is_directory(status)) {
    throw UserError(fmt::format("{}: a folder, not a memory\n    name a file in it", path));
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw UserError(fmt::format("{}: no file that keeps anything\n    name another", path));
  }
}

}  // namespace

MemoryFile::MemoryFile(std::string path, const MemoryOptions& options) : path_(std::move(path)) {
  check_path(path_);
  if (options.access == Access::session) {
    lock_.emplace(path_);
  } else if (!std::filesystem::exists(path_)) {
    throw UserError(
        fmt::format("{}: there is no such memory\n    teach something and it is made: "
                    "striate teach NAME --image PICTURE --memory {}",
                    path_, shell_word(path_)));
  }
  try {
    open_database(options);
    recognise(options);
    if (options.access == Access::session) mark_crashed();
  } catch (const SQLite::Exception& error) {
    throw_memory_error(path_, "opening it", error);
  }
}

void MemoryFile::open_database(const MemoryOptions& options) {
  if (options.access == Access::read) {
    open_to_read(options);
    return;
  }
  int flags = SQLite::OPEN_READWRITE | SQLite::OPEN_NOMUTEX;
  if (options.access == Access::session) flags |= SQLite::OPEN_CREATE;
  database_ = std::make_unique<SQLite::Database>(path_, flags, options.wait_ms);
}

void MemoryFile::open_to_read(const MemoryOptions& options) {
  try {
    // Opened for writing where that is allowed, only so that SQLite can tidy its log away.
    database_ = std::make_unique<SQLite::Database>(
        path_, SQLite::OPEN_READWRITE | SQLite::OPEN_NOMUTEX, options.wait_ms);
    database_->exec("PRAGMA query_only = 1");
    (void)database_->execAndGet("PRAGMA application_id");
    return;
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode() & 0xFF;
    if (code != SQLITE_CANTOPEN && code != SQLITE_READONLY && code != SQLITE_PERM) throw;
  }
  std::error_code none;
  const auto log_bytes = std::filesystem::file_size(path_ + "-wal", none);
  const bool has_log = !none && log_bytes > 0;
  database_ = std::make_unique<SQLite::Database>(
      has_log ? path_ : as_immutable(path_),
      SQLite::OPEN_READONLY | SQLite::OPEN_NOMUTEX | (has_log ? 0 : SQLite::OPEN_URI),
      options.wait_ms);
}

void MemoryFile::copy_to(const std::string& path) {
  // Whoever may only query may not VACUUM INTO another file either.
  const bool only_queries = database_->execAndGet("PRAGMA query_only").getInt64() != 0;
  database_->exec("PRAGMA query_only = 0");
  SQLite::Statement copy(*database_, "VACUUM INTO ?");
  copy.bind(1, path);
  copy.exec();
  if (only_queries) database_->exec("PRAGMA query_only = 1");
}

}  // namespace striate::memory
