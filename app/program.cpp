#include "striate/app/program.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <opencv2/core/utility.hpp>
#include <string>
#include <vector>

#include "striate/app/command_line/empty_names.hpp"
#include "striate/app/command_line/mistakes.hpp"
#include "striate/app/command_line/old_names.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/base/version.hpp"

namespace striate::app {
namespace {

/// First words of --help
constexpr const char* kAbout =
    "Striate: a cognitive robot that sees with a model of the visual cortex.\n\n"
    "Begin here:\n"
    "  striate run corridor --world corridor_a --seed 7\n"
    "      drives the simulated Pioneer down a 60 m corridor\n"
    "  striate sim corridor_a --picture view.png --at \"12 m, 0.2 m, 5 deg\"\n"
    "      shows what the robot sees at a place of a world\n"
    "  striate world --random --seed 7\n"
    "      draws a building to drive in; 'striate world FILE' describes one\n"
    "  striate sim corridor_a --serve\n"
    "      offers the simulated Pioneer on TCP to any ARCOS client; 'striate drive' is one\n"
    "  striate perceive --left L.png --right R.png --out DIR\n"
    "      shows what the vision makes of any image pair; of a folder, a video or a data set, too\n"
    "  striate eval patches DIR\n"
    "      measures the vision on your own data, beside OpenCV's methods\n"
    "  striate teach book --image cover.png --memory home.db\n"
    "  striate memory home.db list\n"
    "      teaches a landmark from images, and looks into what is remembered\n"
    "  striate view home.db\n"
    "      shows a memory, a recording, a trial or a task script in a browser\n"
    "  striate check my_task.yaml my_world.yaml\n"
    "      tells every mistake of task scripts, worlds and settings\n"
    "  striate task actions\n"
    "      lists what a task script can be made of";

/// Last words of --help
constexpr const char* kFooter =
    "\nExit codes: 0 success, 1 mission failed or something broke, 2 a mistake in what was given,\n"
    "130 interrupted. 'striate help COMMAND' explains each command.";

/// Parses and runs the command. @returns false after having said what is wrong with the words.
bool parse(CLI::App& app, std::vector<std::string> words) {
  for (const std::string& note : use_new_names(app, words)) {
    say(stderr, note + "\n");
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    return true;
  } catch (const CLI::ParseError& error) {
    const bool help = error.get_exit_code() == 0;
    const std::string diagnostic =
        help ? unknown_command(app, words) : command_line_diagnostic(app, words, error);
    if (!diagnostic.empty()) say(stderr, diagnostic + "\n");
    return help && diagnostic.empty() && app.exit(error) == 0;
  }
}

int run(int argc, char** argv) {
  CLI::App app{kAbout, "striate"};
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("striate ") + kVersion);
  app.require_subcommand(1);
  // Given twice the last one counts, so that a script can add to a command: ./demo --seed 3
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.get_formatter()->label("TEXT", "FILE");  // where an option takes something else, it says so
  int exit_code = 0;
  add_run_command(app, exit_code);
  add_replay_command(app, exit_code);
  add_export_command(app, exit_code);
  add_recall_command(app, exit_code);
  add_trial_command(app, exit_code);
  add_perceive_command(app, exit_code);
  add_recognise_command(app, exit_code);
  add_odometry_command(app, exit_code);
  add_sim_command(app, exit_code);
  add_world_command(app, exit_code);
  add_task_command(app, exit_code);
  add_drive_command(app, exit_code);
  add_calibrate_command(app, exit_code);
  add_doctor_command(app, exit_code);
  add_check_command(app, exit_code);
  add_config_command(app, exit_code);
  add_ros_command(app, exit_code);
  add_eval_command(app, exit_code);
  add_learn_descriptor_command(app, exit_code);
  add_teach_command(app, exit_code);
  add_memory_command(app, exit_code);
  add_view_command(app, exit_code);
  add_help_command(app, exit_code);
  refuse_empty_names(app);
  return parse(app, {argv + 1, argv + argc}) ? exit_code : 2;
}

/// A disk may be full, and a pipe may have lost its reader: then nothing was told.
int told(int exit_code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) return exit_code;
  say(stderr,
      fmt::format("striate: standard output cannot be written: {}\n", std::strerror(errno)));
  return exit_code == 0 ? 1 : exit_code;
}

/// A file that is opened where a standard stream was closed would be given what is printed: the
/// status line would go into the memory. Read-only, so that writing there still fails.
void fill_closed_streams() {
  for (int stream = 0; stream < 3; ++stream) {
    if (::fcntl(stream, F_GETFD) < 0) (void)!::open("/dev/null", O_RDONLY);
  }
}

}  // namespace

int run_program(int argc, char** argv) {
  fill_closed_streams();
  // One thread: images are small, a robot's cycle must not wait for a busy pool, and trials use
  // the cores by running missions side by side.
  cv::setNumThreads(1);
  try {
    return told(run(argc, argv));
  } catch (const UserError& error) {
    say(stderr, std::string(error.what()) + "\n");
    return 2;
  } catch (const std::exception& error) {
    say(stderr, std::string("striate: ") + error.what() + "\n");
    return 1;
  }
}

}  // namespace striate::app
