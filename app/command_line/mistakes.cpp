#include "striate/app/command_line/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/app/command_line/command_walk.hpp"
#include "striate/config/quantity.hpp"

namespace striate::app {
namespace {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_below(app)) names.push_back(command->get_name());
  return names;
}

std::string text_of(const StrangeWord& strange) {
  const std::string path = path_of(*strange.where);
  const std::string help = path + " --help";
  switch (strange.kind) {
    case StrangeWord::Kind::command:
      return path + ": " + unknown_command(*strange.where, strange.word);
    case StrangeWord::Kind::option:
      return path + ": " + unknown_text("option", strange.word, option_names(*strange.where), help);
    case StrangeWord::Kind::argument:
      break;
  }
  return fmt::format("{}: nothing takes '{}'\n  hint: '{}' says what it takes", path, strange.word,
                     help);
}

std::string text_of(const CLI::App& command, const CLI::ParseError& error) {
  const std::string path = path_of(command);
  const std::vector<std::string> names = command_names(command);
  const bool command_missing =
      error.get_name() == "RequiredError" && !names.empty() && command.get_subcommands().empty();
  if (command_missing) {
    return fmt::format("{}: a command is missing: one of {}\n  hint: '{} --help' explains them",
                       path, fmt::join(names, ", "), path);
  }
  return fmt::format("{}: {}\n  hint: '{} --help' says what it takes", path, error.what(), path);
}

}  // namespace

std::string unknown_text(const std::string& what, const std::string& word,
                         const std::vector<std::string>& names, const std::string& listed_by) {
  const std::string nearest = config::suggest(word, names);
  return fmt::format("unknown {} '{}'\n  hint: {}", what, word,
                     nearest.empty() ? fmt::format("'{}' lists them", listed_by) : nearest);
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
  return unknown_text("command", word, command_names(app), path_of(app) + " --help");
}

std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  for (const StrangeWord& strange : walk_command_line(app, words).strange) {
    if (strange.kind == StrangeWord::Kind::command) return text_of(strange);
  }
  return {};
}

std::string command_line_diagnostic(const CLI::App& app, const std::vector<std::string>& words,
                                    const CLI::ParseError& error) {
  const CommandWalk walk = walk_command_line(app, words);
  return walk.strange.empty() ? text_of(*walk.end, error) : text_of(walk.strange.front());
}

}  // namespace striate::app
