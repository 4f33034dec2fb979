#include "striate/memory/long_term/memory_file.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

#include "striate/base/shell_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/damage.hpp"
#include "striate/memory/long_term/memory_errors.hpp"
#include "striate/memory/long_term/migration.hpp"

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

std::int64_t number(SQLite::Database& database, const char* query) {
  return database.execAndGet(query).getInt64();
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
    (void)number(*database_, "PRAGMA application_id");
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
  const bool only_queries = number(*database_, "PRAGMA query_only") != 0;
  database_->exec("PRAGMA query_only = 0");
  SQLite::Statement copy(*database_, "VACUUM INTO ?");
  copy.bind(1, path);
  copy.exec();
  if (only_queries) database_->exec("PRAGMA query_only = 1");
}

void MemoryFile::recognise(const MemoryOptions& options) {
  const std::int64_t application = number(*database_, "PRAGMA application_id");
  const int version = static_cast<int>(number(*database_, "PRAGMA user_version"));
  if (application == schema::kApplicationId) {
    check_version(options, version);
  } else if (application == 0 && version == 0 &&
             number(*database_, "SELECT count(*) FROM sqlite_master") == 0) {
    if (options.access != Access::session) {
      throw UserError(
          fmt::format("{}: empty, not a memory yet\n    teach something and it becomes "
                      "one: striate teach NAME --image PICTURE --memory {}",
                      path_, shell_word(path_)));
    }
    create(options);
  } else {
    throw UserError(
        fmt::format("{}: an SQLite file, but not a memory of Striate's (application_id "
                    "{}); it was not touched\n    name another file",
                    path_, application));
  }
  database_->exec("PRAGMA foreign_keys = 1");
  if (options.access == Access::read) return;
  database_->exec("PRAGMA synchronous = NORMAL");
  // The log is written back after 1 MB; what a commit costs is small beside that.
  database_->exec("PRAGMA wal_autocheckpoint = 32");
  if (options.most_pages > 0) {
    (void)number(*database_, fmt::format("PRAGMA max_page_count = {}", options.most_pages).c_str());
  }
}

void MemoryFile::check_version(const MemoryOptions& options, int version) {
  if (version > options.version) {
    if (options.access != Access::read) {
      throw UserError(
          fmt::format("{}: version {}, newer than this program's {}; it was not touched"
                      "\n    it can be read (striate memory {} list); to write into it, "
                      "use a newer Striate",
                      path_, version, options.version, shell_word(path_)));
    }
    notices_.push_back(
        fmt::format("{}: version {}, newer than this program's {}: only read; what "
                    "is new in it is not shown",
                    path_, version, options.version));
    return;
  }
  if (version == options.version) {
    if (options.access == Access::session) database_->exec("PRAGMA journal_mode = WAL");
    return;
  }
  if (options.access == Access::session) {
    database_->exec("PRAGMA synchronous = FULL");
    notices_.push_back(migrate(*database_, path_, version, options));
    return;
  }
  // Reading needs today's tables too: a session of a moment brings them up to date.
  database_.reset();
  MemoryOptions upgrade = options;
  upgrade.access = Access::session;
  notices_ = MemoryFile(path_, upgrade).notices();
  open_database(options);
}

void MemoryFile::create(const MemoryOptions& options) {
  database_->exec(fmt::format("PRAGMA page_size = {}", schema::kPage_bytes));
  database_->exec("PRAGMA journal_mode = WAL");
  database_->exec("PRAGMA synchronous = FULL");
  SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
  database_->exec(schema::create());
  // The shipped tables are version kVersion; where more steps are given, they come on top.
  for (const schema::Step& step : options.steps) {
    if (step.to > schema::kVersion && step.to <= options.version) database_->exec(step.sql);
  }
  database_->exec(fmt::format("PRAGMA application_id = {}", schema::kApplicationId));
  database_->exec(fmt::format("PRAGMA user_version = {}", options.version));
  transaction.commit();
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  sync_to_disk(folder.empty() ? "." : folder.string());
}

void MemoryFile::mark_crashed() {
  SQLite::Statement open(*database_, "SELECT id, kind FROM session WHERE state = 'open'");
  std::vector<std::string> sessions;
  while (open.executeStep()) {
    sessions.push_back(fmt::format("session {} ({})", open.getColumn(0).getInt64(),
                                   open.getColumn(1).getString()));
  }
  if (sessions.empty()) return;
  const std::vector<std::string> damage = find_damage(*database_);
  database_->exec(
      "UPDATE session SET state = 'crashed', outcome = 'ended without closing' "
      "WHERE state = 'open'");
  for (const std::string& session : sessions) {
    notices_.push_back(fmt::format("{}: {} ended without closing; marked as crashed; {}", path_,
                                   session,
                                   damage.empty() ? "the check of the whole file found no damage"
                                                  : "the check found damage:"));
  }
  for (const std::string& line : damage) notices_.push_back(path_ + ": " + line);
}

}  // namespace striate::memory
