#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "memory/long_term/schema.hpp"
#include "memory/long_term/writer_lock.hpp"

namespace striate {

enum class Access {
  read,    ///< changes nothing; at any time, also while a mission writes
  edit,    ///< a short change by a person; also while a mission writes
  session  ///< the one writer; makes the file where there is none
};

struct MemoryOptions {
  Access access = Access::read;
  std::string software = "striate";  ///< who opens it: told to others, kept with migrations
  std::int64_t now_unix_s = 0;
  std::int64_t most_pages = 0;  ///< the file grows no further, kPage_bytes each; 0: no bound
  int wait_ms = 5000;           ///< for another writer's commit
  int version = schema::kVersion;
  std::span<const schema::Step> steps = schema::steps();
};

/// A memory on disk, opened and found to be one. A foreign file is refused, an older version is
/// copied to FILE.vN.backup and then migrated, a newer one may only be read. Where the last session
/// did not end, the file is checked and the session marked as crashed. WAL: readers and the writer
/// do not wait for each other.
class MemoryFile {
 public:
  /// @throws UserError with a sentence on what is wrong and how to mend it.
  MemoryFile(std::string path, const MemoryOptions& options);

  [[nodiscard]] SQLite::Database& database() { return *database_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  /// What the person should know: a crash found, a migration done, a newer version.
  [[nodiscard]] const std::vector<std::string>& notices() const { return notices_; }
  /// Writes all of it, as it is now, to a file that is not there yet; also of one opened to read.
  void copy_to(const std::string& path);

 private:
  void open_database(const MemoryOptions& options);
  void open_to_read(const MemoryOptions& options);
  void recognise(const MemoryOptions& options);
  void check_version(const MemoryOptions& options, int version);
  void create(const MemoryOptions& options);
  void mark_crashed();

  std::string path_;
  std::optional<WriterLock> lock_;
  std::unique_ptr<SQLite::Database> database_;
  std::vector<std::string> notices_;
};

}  // namespace striate
