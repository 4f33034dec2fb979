#pragma once

#include <SQLiteCpp/Database.h>

#include <string>
#include <vector>

namespace striate::memory {

/// Looks at every page, every reference and every checksum of a memory.
/// @return one sentence for each damage, naming the landmark and how to mend it; empty: all good.
[[nodiscard]] std::vector<std::string> find_damage(SQLite::Database& database);

}  // namespace striate::memory
