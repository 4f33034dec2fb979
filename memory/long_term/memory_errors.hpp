#pragma once

#include <SQLiteCpp/Exception.h>

#include <string>

namespace striate::memory {

/// The part of SQLite's codes that tells the kind of an error.
inline constexpr int kPrimaryCode = 0xFF;
/// Something in the file cannot be read; the rest may be.
[[nodiscard]] bool is_damage(const SQLite::Exception& error);

/// Turns what SQLite says into a sentence for the person: what, where, how to mend.
/// @param file the memory; @param doing "opening", "keeping 'book'", ...
/// @throws UserError always.
[[noreturn]] void throw_memory_error(const std::string& file, const std::string& doing,
                                     const SQLite::Exception& error);

}  // namespace striate::memory
