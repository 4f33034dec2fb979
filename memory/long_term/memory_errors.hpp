#pragma once

#include <SQLiteCpp/Exception.h>

#include <string>

namespace striate::memory {

/// Turns what SQLite says into a sentence for the person: what, where, how to mend.
/// @param file the memory; @param doing "opening", "keeping 'book'", ...
/// @throws UserError always.
[[noreturn]] void throw_memory_error(const std::string& file, const std::string& doing,
                                     const SQLite::Exception& error);

}  // namespace striate::memory
