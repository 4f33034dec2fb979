#pragma once

#include <cstdint>
#include <span>

/// The tables of the long-term memory. Readable by anyone with the `sqlite3` shell.
namespace striate::memory::schema {

/// "Stri" in the file's header: what tells a memory from any other SQLite file.
inline constexpr std::int64_t kApplicationId = 0x53747269;
/// Kept in `user_version`; grows with each step of `steps`.
inline constexpr int kVersion = 1;
/// With SQLite's usual 4 kB a view of 150 descriptors leaves 28 % of its pages empty, with 32 kB
/// 2.5 %.
inline constexpr int kPage_bytes = 32768;

/// Makes all tables of version kVersion in an empty file.
[[nodiscard]] const char* create();

/// How version `to - 1` becomes version `to`.
struct Step {
  int to = 0;
  const char* sql = "";
};

/// All steps there are, oldest first. Version 1 is the first, so there is none yet; tests bring
/// their own.
[[nodiscard]] std::span<const Step> steps();

}  // namespace striate::memory::schema
