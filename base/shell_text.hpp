#pragma once

#include <string>
#include <string_view>

namespace striate {

/// A word of a printed command, so that a POSIX shell takes it for one word again: as it is where
/// it holds nothing that a shell reads, else in single quotes. Control characters stay; who prints
/// the line makes them plain.
[[nodiscard]] std::string shell_word(std::string_view text);

}  // namespace striate
