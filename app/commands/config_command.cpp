#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "striate/agent/robot_settings.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/configuration_report.hpp"
#include "striate/app/plugin_option.hpp"

namespace striate::app {
namespace {

void print_settings(const std::string& file, bool explain) {
  const std::vector<agent::SettingInForce> settings = agent::settings_in_force(file);
  std::size_t key_width = 0;
  std::size_t value_width = 0;
  for (const agent::SettingInForce& setting : settings) {
    key_width = std::max(key_width, setting.line.key.size());
    value_width = std::max(value_width, setting.line.value.size());
  }
  for (const agent::SettingInForce& setting : settings) {
    fmt::print("{:<{}}  {:<{}}  {}\n", setting.line.key, key_width, setting.line.value, value_width,
               setting.origin);
    if (explain) fmt::print("    {} ({})\n", setting.line.help, setting.line.allowed);
  }
}

}  // namespace

void add_config_command(CLI::App& app, int& exit_code) {
  struct Options {
    std::string robot;
    bool explain = false;
    bool paths = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("config",
                         "Prints every setting in force and where its value came from, or which "
                         "configuration files are found where.\n"
                         "Examples: striate config --robot sharp_eyes --explain\n"
                         "          striate config --paths");
  CLI::Option* robot =
      command->add_option("--robot", options->robot, "settings file; without it the defaults");
  add_plugin_option(*command);
  CLI::Option* explain =
      command->add_flag("--explain", options->explain, "with the meaning and range of each");
  command
      ->add_flag("--paths", options->paths,
                 "instead: where tasks, worlds and robots are looked for, and what is found")
      ->excludes(robot)
      ->excludes(explain);
  command->callback([options, &exit_code] {
    find_robot(options->robot);
    if (options->paths) {
      fmt::print("{}", configuration_report());
    } else {
      print_settings(options->robot, options->explain);
    }
    exit_code = 0;
  });
}

}  // namespace striate::app
