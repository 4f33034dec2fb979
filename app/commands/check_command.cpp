#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "striate/agent/landmark_names.hpp"
#include "striate/agent/robot_settings.hpp"
#include "striate/app/commands/action_list.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/base/user_error.hpp"
#include "striate/config/configuration_path.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::app {
namespace {

enum class Kind { world, task, settings };

/// Tells a world, a task script and robot settings apart by their keys at the left edge; also where
/// the rest is not readable as YAML.
Kind kind_of(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  Kind kind = Kind::settings;
  for (int i = 0; i < 10000 && std::getline(stream, line); ++i) {
    if (line.rfind("striate_world:", 0) == 0) return Kind::world;
    if (line.rfind("striate:", 0) == 0 || line.rfind("do:", 0) == 0) kind = Kind::task;
  }
  return kind;
}

/// Names that the memory knows; none where no memory was given: `needs` is not judged then.
using Known = std::optional<std::vector<std::string>>;

void check_file(const std::string& file, const Known& known) {
  switch (std::filesystem::is_regular_file(file) ? kind_of(file) : Kind::settings) {
    case Kind::world:
      (void)simulator::load_world(file);
      break;
    case Kind::task:
      fmt::print(stderr, "{}",
                 tasks::check_task(file, RobotDescription{}, known ? &*known : nullptr).notices);
      break;
    case Kind::settings: {
      std::string warnings;
      (void)agent::load_robot_settings(file, &warnings);
      fmt::print(stderr, "{}", warnings);
      break;
    }
  }
}

int check_files(const std::vector<std::string>& files, const Known& known) {
  int bad = 0;
  for (const std::string& given : files) {
    try {
      const std::string file = config::find_configuration(given, config::FileKind::any);
      check_file(file, known);
      fmt::print("{}: good\n", file);
    } catch (const UserError& error) {
      ++bad;
      fmt::print(stderr, "{}\n", error.what());
    }
  }
  return bad == 0 ? 0 : 2;
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  struct Options {
    std::vector<std::string> files;
    std::string memory;
    bool actions = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "check",
      "Checks task scripts, worlds and robot settings without running them, and tells every\n"
      "mistake with its file, line and column. Exit code 2 if there is one.");
  command->add_option("files", options->files, "YAML files");
  add_plugin_option(*command);
  command->add_option("--memory", options->memory,
                      "the long-term memory that must know the landmarks a task needs");
  command->add_flag("--actions", options->actions,
                    "lists what a task script can use, as 'striate task actions' does");
  command->callback([options, &exit_code] {
    if (options->actions) fmt::print("{}", actions_as_text());
    if (!options->actions && options->files.empty()) {
      throw UserError("nothing to check: name one or more YAML files, or give --actions");
    }
    Known known;
    if (!options->memory.empty()) {
      if (!std::filesystem::exists(options->memory)) {
        throw UserError(fmt::format("{}: there is no such memory", options->memory));
      }
      known = agent::landmark_names_in(options->memory);
    }
    exit_code = check_files(options->files, known);
  });
}

}  // namespace striate::app
