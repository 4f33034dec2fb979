#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/robot_settings.hpp"
#include "behaviours/registry.hpp"
#include "config/node.hpp"
#include "config/user_error.hpp"
#include "platform/simulator/world_reader.hpp"
#include "tasks/condition.hpp"
#include "tasks/task_reader.hpp"

namespace striate {
namespace {

/// Tells a world, a task script and robot settings apart by their first key.
void check_file(const std::string& file) {
  config::Mistakes mistakes(file);
  const config::Node root = load_yaml(mistakes);
  mistakes.throw_if_any();
  if (root.find("striate_world") != nullptr) {
    (void)simulator::load_world(file);
  } else if (root.find("striate") != nullptr || root.find("do") != nullptr) {
    (void)load_task(file, RobotDescription{});
  } else {
    (void)load_robot_settings(file);
  }
}

int check_files(const std::vector<std::string>& files) {
  int bad = 0;
  for (const std::string& file : files) {
    try {
      check_file(file);
      fmt::print("{}: good\n", file);
    } catch (const UserError& error) {
      ++bad;
      fmt::print(stderr, "{}\n", error.what());
    }
  }
  return bad == 0 ? 0 : 2;
}

void print_actions() {
  fmt::print("Actions:\n");
  for (const BehaviourEntry& behaviour : behaviour_registry()) {
    fmt::print("  {}: {}\n", behaviour.name, behaviour.help);
    for (const config::SettingLine& line : behaviour.parameters()) {
      fmt::print("      {}: {}   {} ({})\n", line.key, line.value, line.help, line.allowed);
    }
  }
  fmt::print("\nConditions for 'until':\n");
  for (const ConditionEntry& condition : condition_registry()) {
    fmt::print("  {}: {} ({} .. {})\n", condition.name, condition.help,
               config::print_quantity(condition.range.low, condition.unit),
               config::print_quantity(condition.range.high, condition.unit));
  }
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  struct Options {
    std::vector<std::string> files;
    bool actions = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "check",
      "Checks task scripts, worlds and robot settings without running them, and tells every\n"
      "mistake with its file, line and column. Exit code 2 if there is one.");
  command->add_option("files", options->files, "YAML files");
  command->add_flag("--actions", options->actions,
                    "lists the actions and conditions that a task script can use");
  command->callback([options, &exit_code] {
    if (options->actions) print_actions();
    if (!options->actions && options->files.empty()) {
      throw UserError("nothing to check: name one or more YAML files, or give --actions");
    }
    exit_code = check_files(options->files);
  });
}

}  // namespace striate
