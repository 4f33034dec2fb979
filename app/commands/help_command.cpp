#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "striate/agent/open_memory.hpp"
#include "striate/app/command_line/command_walk.hpp"
#include "striate/app/command_line/completion.hpp"
#include "striate/app/command_line/manual_page.hpp"
#include "striate/app/command_line/mistakes.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

struct HelpOptions {
  std::vector<std::string> command;
  bool man = false;
  std::string completion;
};

/// What `COMMAND --help` prints.
std::string help_of_command(const CLI::App& app, const std::vector<std::string>& names) {
  const CLI::App* command = &app;
  for (const std::string& name : names) {
    const CLI::App* below = command_below(*command, name);
    if (below == nullptr)
      throw UserError(path_of(*command) + ": " + unknown_command(*command, name));
    command = below;
  }
  return app.get_formatter()->make_help(command, path_of(*command), CLI::AppFormatMode::Normal);
}

std::string asked_for(const CLI::App& app, const HelpOptions& options) {
  if (options.man) return manual_page(describe(app), agent::software_name());
  if (options.completion == "bash") return bash_completion(describe(app));
  if (options.completion == "zsh") return zsh_completion(describe(app));
  return help_of_command(app, options.command);
}

}  // namespace

void add_help_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<HelpOptions>();
  CLI::App* command = app.add_subcommand(
      "help",
      "Explains a command as its --help does, or prints the manual page or a shell's completion.\n"
      "Examples: striate help memory list\n"
      "          striate help --man > striate.1\n"
      "          source <(striate help --completion bash)");
  command->add_option("command", options->command, "the command, e.g. memory list")
      ->type_name("COMMAND");
  CLI::Option* man =
      command->add_flag("--man", options->man, "the manual page striate(1), as roff");
  command->add_option("--completion", options->completion, "the completion script of a shell")
      ->check(CLI::IsMember({"bash", "zsh"}))
      ->excludes(man);
  command->callback([&app, options, &exit_code] {
    fmt::print("{}", asked_for(app, *options));
    exit_code = 0;
  });
}

}  // namespace striate::app
