#include "striate/app/command_line/empty_names.hpp"

#include <string>

namespace striate::app {
namespace {

/// TEXT is what CLI11 calls the type of a name; help shows it as FILE.
bool takes_name(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  for (const char* name : {"TEXT", "FILE", "FOLDER"}) {
    if (type.rfind(name, 0) == 0) return option.get_items_expected_max() > 0;
  }
  return false;
}

std::string say_if_empty(const std::string& name) {
  return name.empty() ? "the name is empty" : "";
}

}  // namespace

void refuse_empty_names(CLI::App& app) {
  for (CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    if (takes_name(*option)) option->check(say_if_empty);
  }
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    refuse_empty_names(*command);
  }
}

}  // namespace striate::app
