#include "striate/app/command_line/command_text.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "striate/app/command_line/command_walk.hpp"

namespace striate::app {
namespace {

/// CLI11 says "FLOAT:FLOAT in [-60 - 60]", "TEXT:{a,b}" or "UINT:0..9" of an option with a check.
void read_type(const std::string& type, OptionText& text) {
  static const std::regex kRange(R"(in \[(\S+) - (\S+)\])");
  static const std::regex kFromTo(R"((\d+)\.\.(\d+))");
  static const std::regex kChoices(R"(\{(.*)\})");
  const std::size_t colon = type.find(':');
  text.value = type.substr(0, colon);
  if (text.value == "TEXT") text.value = "FILE";
  if (colon == std::string::npos) return;
  const std::string check = type.substr(colon + 1);
  std::smatch match;
  if (std::regex_search(check, match, kRange) || std::regex_search(check, match, kFromTo)) {
    text.range = fmt::format("from {} to {}", match[1].str(), match[2].str());
  } else if (check == "POSITIVE") {
    text.range = "above 0";
  } else if (std::regex_search(check, match, kChoices)) {
    text.value = "WORD";
    std::istringstream list(match[1].str());
    for (std::string one; std::getline(list, one, ',');) text.choices.push_back(one);
  }
}

OptionText describe_option(const CLI::Option& option, bool as_argument) {
  OptionText text;
  if (as_argument) {
    text.names = {option.get_name(true, false)};
  } else {
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  }
  if (option.get_items_expected_max() > 0) read_type(option.get_type_name(), text);
  text.default_value = option.get_default_str();
  text.help = option.get_description();
  text.required = option.get_required();
  text.repeated = option.get_items_expected_max() > 1;
  for (const CLI::Option* needed : option.get_needs()) text.needs.push_back(needed->get_name());
  return text;
}

/// The description up to the line that begins with "Example" (of `striate` itself "Begin here"),
/// and the lines from there on.
void read_about(const std::string& description, CommandText& text) {
  std::istringstream lines(description);
  bool examples = false;
  for (std::string line; std::getline(lines, line);) {
    examples = examples || line.rfind("Example", 0) == 0 || line.rfind("Begin here", 0) == 0;
    if (examples) {
      text.examples.push_back(line);
    } else {
      text.about += line + "\n";
    }
  }
}

/// `striate help` takes the names of the other commands.
void add_command_names(const CLI::App& app, CommandText& text) {
  for (OptionText& argument : text.arguments) {
    if (argument.value != "COMMAND" || app.get_parent() == nullptr) continue;
    for (const CLI::App* command : commands_below(*app.get_parent())) {
      argument.choices.push_back(command->get_name());
    }
  }
}

}  // namespace

CommandText describe(const CLI::App& app) {
  CommandText text;
  text.path = path_of(app);
  text.passes_on = app.get_fallthrough() && app.get_parent() != nullptr;
  read_about(app.get_description(), text);
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    if (option->get_positional()) text.arguments.push_back(describe_option(*option, true));
    if (option->nonpositional()) text.options.push_back(describe_option(*option, false));
  }
  add_command_names(app, text);
  for (const CLI::App* command : commands_below(app)) text.commands.push_back(describe(*command));
  return text;
}

}  // namespace striate::app
