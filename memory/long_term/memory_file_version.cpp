#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

#include "striate/base/shell_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/damage.hpp"
#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/migration.hpp"

namespace striate::memory {
namespace {

std::int64_t number(SQLite::Database& database, const char* query) {
  return database.execAndGet(query).getInt64();
}

}  // namespace

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
