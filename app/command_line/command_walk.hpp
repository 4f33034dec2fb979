#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace striate::app {

/// A word of the command line that no command, option or argument takes.
struct StrangeWord {
  enum class Kind { command, option, argument };
  Kind kind = Kind::argument;
  std::size_t index = 0;            ///< among the words after the program's name
  std::string word;                 ///< of an option without "=value"
  const CLI::App* where = nullptr;  ///< the command in force there
};

struct CommandWalk {
  const CLI::App* end = nullptr;     ///< the innermost command that was named
  std::vector<StrangeWord> strange;  ///< in their order
};

/// Reads the words as CLI11 does, but goes on where CLI11 gives up, and remembers where that was.
/// @param words without the program's name
[[nodiscard]] CommandWalk walk_command_line(const CLI::App& app,
                                            const std::vector<std::string>& words);

/// "striate memory list": the names down to the command.
[[nodiscard]] std::string path_of(const CLI::App& command);

/// The command of that name right below; none: nullptr.
[[nodiscard]] const CLI::App* command_below(const CLI::App& app, const std::string& name);

/// The commands right below that are shown in help, in their order.
[[nodiscard]] std::vector<const CLI::App*> commands_below(const CLI::App& app);

/// Names with their dashes of the options that help shows there; where a command takes those of the
/// command above it, these too.
[[nodiscard]] std::vector<std::string> option_names(const CLI::App& app);

}  // namespace striate::app
