#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "striate/agent/robot_settings.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/foxglove_options.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/app/view/task_pages.hpp"
#include "striate/app/view/trial_pages.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/replay/recording_reader.hpp"
#include "striate/viewer/dashboard/memory_pages.hpp"
#include "striate/viewer/dashboard/shown_run.hpp"
#include "striate/viewer/dashboard/what.hpp"
#include "striate/viewer/foxglove/foxglove_server.hpp"
#include "striate/viewer/mcap/mcap_reader.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;
using viewer::dashboard::Site;

struct ViewOptions {
  std::vector<std::string> files;
  std::uint16_t port = FoxgloveOptions::kViewPort;
  std::string listen = "127.0.0.1";
  std::string robot;
  bool read_only = false;
  bool open = false;
};

/// SQLite's first bytes, of every database (www.sqlite.org/fileformat.html)
constexpr std::string_view kSqlite = "SQLite format 3";

bool is_memory_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(kSqlite.size(), '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == kSqlite;
}

bool is_run_file(const std::string& file) {
  return fs::is_regular_file(file) && (replay::is_recording(file) || viewer::mcap::is_mcap(file));
}

/// A file as its own kind of page. @return the page's name
std::string add_page_of(Site& site, const ViewOptions& options) {
  std::string file = options.files.front();
  if (fs::is_directory(file)) {
    if (!is_trial_folder(file)) {
      throw UserError(
          fmt::format("{}: is no folder of a trial: there is no 'runs' in it\n"
                      "    give one that 'striate trial --out' has written, or a file",
                      file));
    }
    add_trial_pages(site, file);
    return "trials";
  }
  if (is_run_file(file)) {
    viewer::dashboard::ShownRuns runs;
    for (const std::string& one : options.files) {
      runs.push_back(std::make_shared<viewer::dashboard::ShownRun>(one));
    }
    viewer::dashboard::add_recording_pages(site, runs);
    return "recording";
  }
  if (fs::is_regular_file(file) && is_memory_file(file)) {
    const auto settings = agent::load_robot_settings(options.robot).long_term_memory;
    viewer::dashboard::add_memory_pages(site, {file, settings, !options.read_only});
    return "memory";
  }
  find_task(file);
  if (!fs::is_regular_file(file)) {
    throw UserError(fmt::format("{}: is no file that can be shown\n    is the path right?", file));
  }
  add_task_pages(site, file);
  return "task";
}

/// @throws UserError where several files do not belong together
void check_view_files(const ViewOptions& options) {
  if (options.files.size() == 1) return;
  for (const std::string& file : options.files) {
    if (options.files.size() == 2 && is_run_file(file)) continue;
    throw UserError(fmt::format(
        "{}: two files are compared where both are recordings; else one is shown", file));
  }
}

/// In the browser that the desktop has; a child of its own, so that it outlives this program.
void open_browser(const std::string& url) {
  const pid_t child = ::fork();
  if (child != 0) {
    if (child > 0) ::waitpid(child, nullptr, 0);
    return;
  }
  if (::fork() == 0) {
    ::setsid();
    ::execlp("xdg-open", "xdg-open", url.c_str(), nullptr);
  }
  ::_exit(0);
}

int run_view(const ViewOptions& options) {
  check_view_files(options);
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  auto site = std::make_shared<Site>();
  viewer::dashboard::What what;
  what.kind = "file";
  what.pages = {add_page_of(*site, options)};
  what.changes = what.pages.front() == "memory" && !options.read_only;
  what.title = fs::path(options.files.front()).filename().string();
  if (what.title.empty()) what.title = options.files.front();
  for (std::size_t k = 1; k < options.files.size(); ++k) {
    what.title += " and " + fs::path(options.files[k]).filename().string();
  }
  viewer::dashboard::add_what(*site, what);

  viewer::foxglove::ServerOptions server;
  server.address = options.listen;
  server.port = options.port;
  server.others = false;
  server.site = site;
  server.needs_token = what.changes;
  viewer::foxglove::FoxgloveServer shown(server, {},
                                         viewer::Channels(RobotDescription{}, tasks::Task{}));
  say(stderr, fmt::format("Dashboard: {}\nCtrl-C ends it.\n", shown.page_url()));
  if (options.open) open_browser(shown.page_url());
  // By hand: a person does not notice it
  constexpr auto kLookAgain = std::chrono::milliseconds(50);
  while (!Interrupt::requested()) std::this_thread::sleep_for(kLookAgain);
  return 0;
}

}  // namespace

void add_view_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand(
      "view",
      "Shows a file as pages in a browser: a memory, a recording, an MCAP file of a run, a\n"
      "folder of a trial, or a task script; two recordings side by side.\n"
      "Examples: striate view home.db\n"
      "          striate view run.rec\n"
      "          striate view run.rec other.rec\n"
      "          striate view out/trial\n"
      "A robot that runs is shown by 'striate run ... --view'.\n"
      "What may change a memory needs the token in the printed address; --read-only: nobody may.");
  command->add_option("file", options->files, "what is shown")->required()->expected(1, 2);
  command->add_option("--port", options->port, "the port that is listened on; 0: any")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command
      ->add_option("--listen", options->listen,
                   "address for browsers on other machines, 0.0.0.0 for all; a token is needed "
                   "then, and printed")
      ->type_name("ADDRESS");
  command->add_option("--robot", options->robot, "settings by which the memory forgets");
  command->add_flag("--read-only", options->read_only, "a memory cannot be changed");
  command->add_flag("--open", options->open, "opens it in the desktop's browser");
  add_plugin_option(*command);
  command->callback([options, &exit_code] {
    find_robot(options->robot);
    exit_code = run_view(*options);
  });
}

}  // namespace striate::app
