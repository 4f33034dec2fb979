#pragma once

#include <SQLiteCpp/Transaction.h>

#include <string>

#include "striate/memory/long_term/memory_errors.hpp"
#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::agent {

/// Options of a command that opens a memory: who it is and what the calendar says.
/// @param who e.g. "striate teach".
[[nodiscard]] memory::MemoryOptions memory_options(memory::Access access, const std::string& who);

/// "striate 0.1.0": kept with sessions and migrations.
[[nodiscard]] std::string software_name();

/// Tells the person what opening found, on standard error.
void print_notices(const std::vector<std::string>& notices);

/// Opens a memory, hands its tables to `work`, and commits what that changed, on the disk before it
/// returns. @param doing for the sentence of an error: "forgetting 'book'".
/// @throws UserError as MemoryFile does, and where the disk refuses.
template <class Work>
void with_memory(const std::string& path, memory::Access access, const std::string& doing,
                 Work work) {
  memory::MemoryFile file(path, memory_options(access, "striate"));
  print_notices(file.notices());
  try {
    memory::MemoryTables tables(file.database());
    if (access == memory::Access::read) {
      // One transaction, so that all that is read belongs together while a mission writes.
      const SQLite::Transaction snapshot(file.database());
      work(tables, file);
      return;
    }
    file.database().exec("PRAGMA synchronous = FULL");
    SQLite::Transaction transaction(file.database(), SQLite::TransactionBehavior::IMMEDIATE);
    work(tables, file);
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    memory::throw_memory_error(path, doing, error);
  }
}

}  // namespace striate::agent
