#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace striate::app {

/// What is wrong with a command line that CLI11 did not accept, and the nearest that would be
/// right: "striate: unknown command 'trail'\n  hint: did you mean 'trial'?". Ends without a
/// newline.
/// @param words without the program's name
[[nodiscard]] std::string command_line_diagnostic(const CLI::App& app,
                                                  const std::vector<std::string>& words,
                                                  const CLI::ParseError& error);

/// The same for the first word that is no command, also where help was asked for; empty: there is
/// none.
[[nodiscard]] std::string unknown_command(const CLI::App& app,
                                          const std::vector<std::string>& words);

/// "unknown command 'lits'" and the nearest of those right below `app`.
[[nodiscard]] std::string unknown_command(const CLI::App& app, const std::string& word);

/// "unknown WHAT 'word'" with the nearest of the names, or else with where they are listed.
[[nodiscard]] std::string unknown_text(const std::string& what, const std::string& word,
                                       const std::vector<std::string>& names,
                                       const std::string& listed_by);

}  // namespace striate::app
