#include "striate/app/commands/memory_command.hpp"

#include "striate/app/commands/commands.hpp"

namespace striate::app {

void add_memory_command(CLI::App& app, int& exit_code) {
  auto shared = std::make_shared<MemoryCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "memory",
      "Looks into a long-term memory, and changes it; also while a mission has it open.\n"
      "Examples: striate memory home.db list\n"
      "          striate memory home.db why book\n"
      "          striate memory home.db show book --picture book.png\n"
      "The file is an SQLite database: the sqlite3 shell opens it too.");
  command->require_subcommand(1);
  command->add_option("file,--memory", shared->file, "the memory")->capture_default_str();
  command->add_option("--robot", shared->robot, "settings of the robot and its mind");
  command->add_flag("--json", shared->json, "print JSON instead of text");
  add_memory_look_verbs(*command, shared, exit_code);
  add_memory_map_verbs(*command, shared, exit_code);
  add_memory_change_verbs(*command, shared, exit_code);
  add_memory_file_verbs(*command, shared, exit_code);
  for (CLI::App* verb : command->get_subcommands({})) verb->fallthrough();
}

}  // namespace striate::app
