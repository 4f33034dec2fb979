#pragma once

#include <SQLiteCpp/Database.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "striate/memory/long_term/memory_options.hpp"
#include "striate/memory/long_term/writer_lock.hpp"

namespace striate::memory {

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

}  // namespace striate::memory
