#pragma once

#include <SQLiteCpp/Database.h>

#include <string>

#include "striate/memory/long_term/memory_options.hpp"

namespace striate::memory {

/// Brings an older memory to `options.version`: first a copy to FILE.vN.backup, then all steps in
/// one transaction, which is checked before it is committed. Whatever ends it half-way, the file is
/// as it was.
/// @return what was done, in a sentence.
/// @throws UserError where a step is missing, or the file is damaged; SQLite::Exception otherwise.
[[nodiscard]] std::string migrate(SQLite::Database& database, const std::string& path, int from,
                                  const MemoryOptions& options);

/// Has what was written to a file, or what a folder lists, reach the disk.
void sync_to_disk(const std::string& path);

}  // namespace striate::memory
