#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace striate::app {

/// Options were renamed so that a bare number carries its unit in the option's name. The old names
/// still work in this version: they are replaced here, before CLI11 reads them, so that help,
/// manual page, completion and messages know the new names only.
/// @param words without the program's name; old names are replaced in place
/// @returns a note for each: what to write from now on
[[nodiscard]] std::vector<std::string> use_new_names(const CLI::App& app,
                                                     std::vector<std::string>& words);

}  // namespace striate::app
