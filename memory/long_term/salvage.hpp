#pragma once

#include <SQLiteCpp/Database.h>

#include <string>
#include <vector>

namespace striate::memory {

/// A file that ends before the length that its header tells is opened by no SQLite. Writes a copy
/// that is filled up with zeros, so that the pages that are there can be read.
/// @return whether the file was cut off; else nothing is written
bool fill_up(const std::string& file, const std::string& copy);

/// Copies every row that can still be read from a damaged memory into a fresh one, each by itself:
/// a page that cannot be read costs the rows on it and no others. What a row refers to and is lost
/// gets a stand-in: a session with the outcome `lost`, a landmark named `lost_landmark_N`.
/// @param fresh an empty memory of the same version
/// @return one sentence for each table of which something is left out, saying how much
/// @throws SQLite::Exception where the fresh one cannot be written
[[nodiscard]] std::vector<std::string> salvage(SQLite::Database& damaged, SQLite::Database& fresh);

}  // namespace striate::memory
