#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace striate::app {

/// An option or argument as manual page and completion need it.
struct OptionText {
  std::vector<std::string> names;    ///< "--seed", "-h"; of an argument its name alone
  std::string value;                 ///< what it takes: FILE, UINT, ...; empty: a flag
  std::string range;                 ///< "from 1 to 50"; empty: none is known
  std::vector<std::string> choices;  ///< all values; empty: no closed set
  std::string default_value;
  std::string help;
  std::vector<std::string> needs;  ///< does nothing without these
  bool required = false;
  bool repeated = false;
  [[nodiscard]] bool takes_files() const { return value == "FILE" || value == "FOLDER"; }
};

/// A command and those below it, read from the command line's own definition.
struct CommandText {
  std::string path;  ///< "striate memory list"
  std::string about;
  std::vector<std::string> examples;  ///< lines of the about text from "Example" on
  std::vector<OptionText> arguments;
  std::vector<OptionText> options;  ///< without those passed up to the command above
  bool passes_on = false;           ///< takes the options of the command above, too
  std::vector<CommandText> commands;
};

[[nodiscard]] CommandText describe(const CLI::App& app);

}  // namespace striate::app
