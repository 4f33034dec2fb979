#include "striate/memory/long_term/migration.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/damage.hpp"

namespace striate::memory {
namespace {

/// A whole copy under its final name, or none.
std::string back_up(SQLite::Database& database, const std::string& path, int version) {
  std::string name = fmt::format("{}.v{}.backup", path, version);
  const std::string part = name + ".part";
  std::filesystem::remove(part);
  SQLite::Statement copy(database, "VACUUM INTO ?");
  copy.bind(1, part);
  copy.exec();
  sync_to_disk(part);
  std::filesystem::rename(part, name);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  sync_to_disk(folder.empty() ? "." : folder.string());
  return name;
}

void apply(SQLite::Database& database, const schema::Step& step, const MemoryOptions& options,
           const std::string& backup) {
  database.exec(step.sql);
  SQLite::Statement note(database, "INSERT INTO migration VALUES (?, ?, ?, ?)");
  note.bind(1, step.to);
  note.bind(2, options.now_unix_s);
  note.bind(3, options.software);
  note.bind(4, backup);
  note.exec();
}

}  // namespace

void sync_to_disk(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

std::string migrate(SQLite::Database& database, const std::string& path, int from,
                    const MemoryOptions& options) {
  const std::string backup = back_up(database, path, from);
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  int version = from;
  for (const schema::Step& step : options.steps) {
    if (step.to != version + 1 || step.to > options.version) continue;
    apply(database, step, options, backup);
    version = step.to;
  }
  if (version != options.version) {
    throw UserError(
        fmt::format("{}: version {}, and there is no way from it to version {}\n    "
                    "it was left as it is; open it with the program that wrote it",
                    path, from, options.version));
  }
  const std::vector<std::string> damage = find_damage(database);
  if (!damage.empty()) {
    throw UserError(
        fmt::format("{}: not brought from version {} to {}, because it is damaged: {}\n"
                    "    it was left as it is; a copy is in {}",
                    path, from, version, damage.front(), backup));
  }
  database.exec(fmt::format("PRAGMA user_version = {}", version));
  transaction.commit();
  return fmt::format("{}: brought from version {} to {}; the old one is kept in {}", path, from,
                     version, backup);
}

}  // namespace striate::memory
