#include <fmt/format.h>

#include <memory>
#include <string>

#include "striate/app/command_line/found_file.hpp"
#include "striate/app/commands/action_list.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/base/files.hpp"
#include "striate/base/files_apart.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::app {
namespace {

struct ShowOptions {
  std::string file;
  std::string svg;
  std::string xml;
};

int show(const ShowOptions& options) {
  check_apart({{"--svg", options.svg}, {"--xml", options.xml}},
              {{"the task script", options.file}});
  check_writable(options.svg);
  check_writable(options.xml);
  const tasks::Task task = tasks::check_task(options.file, RobotDescription{});
  fmt::print(stderr, "{}", task.notices);
  if (!options.svg.empty()) write_file(options.svg, tasks::svg_tree(task.outline));
  if (!options.xml.empty()) write_file(options.xml, tasks::xml_tree(task.outline));
  if (options.svg.empty() && options.xml.empty()) fmt::print("{}", tasks::text_tree(task.outline));
  return 0;
}

void add_show(CLI::App& command, int& exit_code) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* show_command = command.add_subcommand("show", "draws the tree of a task script");
  show_command->add_option("file", options->file, "the task script")->required();
  add_plugin_option(*show_command);
  show_command->add_option("--svg", options->svg, "write an image instead");
  show_command->add_option("--xml", options->xml,
                           "write the XML of BehaviorTree.CPP 4 instead, for its editors");
  show_command->callback([options, &exit_code] {
    find_task(options->file);
    exit_code = show(*options);
  });
}

void add_actions(CLI::App& command, int& exit_code) {
  auto json = std::make_shared<bool>(false);
  auto name = std::make_shared<std::string>();
  CLI::App* actions = command.add_subcommand(
      "actions", "lists the actions and conditions that a script can use, with an example each");
  actions->add_option("name", *name, "only this one")->type_name("ACTION");
  add_plugin_option(*actions);
  actions->add_flag("--json", *json, "print them as JSON");
  actions->callback([json, name, &exit_code] {
    fmt::print("{}", *json ? actions_as_json(*name).dump(2) + "\n" : actions_as_text(*name));
    exit_code = 0;
  });
}

}  // namespace

void add_task_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("task",
                                         "Draws task scripts, and lists what they can be made of.\n"
                                         "Examples: striate task show corridor --svg corridor.svg\n"
                                         "          striate task actions back_up");
  command->require_subcommand(1);
  add_show(*command, exit_code);
  add_actions(*command, exit_code);
}

}  // namespace striate::app
