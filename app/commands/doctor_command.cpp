#include <fmt/format.h>

#include <memory>
#include <utility>

#include "striate/agent/robot_settings.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/doctor/bridge.hpp"
#include "striate/app/doctor/configuration.hpp"
#include "striate/app/doctor/devices.hpp"
#include "striate/app/doctor/machine.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

struct DoctorOptions {
  std::string robot;
  std::string memory;
  std::string config;  ///< empty: every folder that names are looked for in
};

const char* word_for(Finding::Grade grade) {
  switch (grade) {
    case Finding::Grade::good:
      return "good ";
    case Finding::Grade::note:
      return "note ";
    case Finding::Grade::wrong:
      break;
  }
  return "WRONG";
}

/// What a finding says may have lines of its own.
std::string indented(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c;
    if (c == '\n') result += "         ";
  }
  return result;
}

void print(const char* title, const Findings& findings) {
  fmt::print("{}\n", title);
  for (const Finding& finding : findings) {
    fmt::print("  {}  {}: {}\n", word_for(finding.grade), finding.about, indented(finding.what));
    if (!finding.mend.empty()) fmt::print("         -> {}\n", finding.mend);
  }
}

Findings look_at_robot(const std::string& file) {
  try {
    const agent::RobotSettings settings = agent::load_robot_settings(file);
    Findings findings = look_at_places(settings.pioneer);
    for (Finding& finding : look_at_bridge(settings)) findings.push_back(std::move(finding));
    return findings;
  } catch (const UserError& error) {
    return {{Finding::Grade::wrong, file, error.what(), "correct the file"}};
  }
}

int doctor(const DoctorOptions& options) {
  bool wrong = false;
  const auto show = [&](const char* title, const Findings& findings) {
    print(title, findings);
    wrong = wrong || any_wrong(findings);
  };
  show("Machine", look_at_machine(this_machine()));
  show("Devices", look_at_devices({}));
  if (!options.robot.empty()) show("Robot", look_at_robot(options.robot));
  show("Configuration",
       options.config.empty() ? look_at_configurations() : look_at_configuration(options.config));
  if (!options.memory.empty()) show("Memory", {look_at_memory(options.memory)});
  fmt::print("{}\n", wrong ? "Something will not work: see WRONG above." : "All is well.");
  return wrong ? 1 : 0;
}

}  // namespace

void add_doctor_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DoctorOptions>();
  CLI::App* command = app.add_subcommand(
      "doctor",
      "Looks at the machine, its devices, the configuration and the memory, and says what is "
      "wrong\n"
      "and how to mend it. Exit code 1 if something will not work.\n"
      "Example: striate doctor --robot pioneer --memory home.db");
  command->add_option("--robot", options->robot, "settings; its devices are tried, nothing moves");
  add_plugin_option(*command);
  command->add_option("--memory", options->memory, "a long-term memory to check");
  command->add_option("--config", options->config,
                      "folder with worlds, tasks and robots; without it those of "
                      "'striate config --paths'");
  command->callback([options, &exit_code] {
    find_robot(options->robot);
    exit_code = doctor(*options);
  });
}

}  // namespace striate::app
