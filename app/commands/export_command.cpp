#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "striate/agent/replay/replay_mission.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/mcap_options.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/viewer/recording/facts_file.hpp"

namespace striate::app {
namespace {

struct ExportOptions {
  std::string recording;
  McapOptions mcap;
  bool quiet = false;
};

/// A file that is read cannot be written at the same time.
void refuse_same_file(const ExportOptions& options) {
  std::error_code none;
  if (!std::filesystem::equivalent(options.recording, options.mcap.file, none)) return;
  throw UserError(fmt::format("--mcap {}: is the recording itself\n    give a file of its own",
                              options.mcap.file));
}

void tell(const ExportOptions& options, const agent::ReplayMission& mission,
          const viewer::FactsFile& file) {
  if (options.quiet) return;
  fmt::print("{}: {} cycles, {:.1f} MB\n", options.mcap.file, file.whole_cycles(),
             static_cast<double>(file.bytes()) / 1e6);
  if (mission.ending() == replay::Ending::cut_off) {
    fmt::print("  the recording is cut off: the run was killed or the disk was full\n");
  }
}

int run_export(const ExportOptions& options) {
  refuse_same_file(options);
  check_writable(options.mcap.file);
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  agent::ReplayMission mission({.recording = options.recording, .robot = {}, .task = {}});
  viewer::FactsFile file(options.mcap.file, compression_of(options.mcap), mission.setup(),
                         mission.executive().task());
  viewer::FactsTaker taker;
  viewer::CycleFacts facts;
  try {
    while (!Interrupt::requested() && mission.step()) {
      taker.take(mission.cycle(), mission.executive(), mission.recorded().number, facts);
      file.add(facts);
    }
    file.close();
  } catch (const UserError&) {
    file.close();  // damage of the recording: what stood before it is good
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}; it ends after {} cycles",
                                         options.mcap.file, error.what(), file.whole_cycles()));
  }
  tell(options, mission, file);
  return Interrupt::requested() ? 130 : 0;
}

}  // namespace

void add_export_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand(
      "export",
      "Writes a recording (striate run --record) as an MCAP file, for Foxglove, Lichtblick, Rerun\n"
      "and ROS 2: images, odometry, scans, maps, obstacles, landmarks, commands and the task.\n"
      "What the robot saw and remembered is computed again from what it felt.\n"
      "Example: striate export run.rec --mcap run.mcap\n"
      "Times in the file are the mission's: zero is where the body started.\n"
      "A recording that is cut off is exported as far as it goes.");
  command->add_option("recording", options->recording, "the recording")->required();
  add_mcap_options(*command, options->mcap)->required();
  add_plugin_option(*command);
  command->add_flag("--quiet", options->quiet, "print nothing");
  command->callback([options, &exit_code] { exit_code = run_export(*options); });
}

}  // namespace striate::app
