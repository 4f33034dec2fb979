#include <fmt/format.h>

#include <memory>
#include <optional>

#include "striate/agent/memory_json.hpp"
#include "striate/agent/pictures/map_picture.hpp"
#include "striate/agent/recall/memory_state.hpp"
#include "striate/agent/replay/replay_mission.hpp"
#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/memory/text_table.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/app/pose_text.hpp"
#include "striate/app/recall/print_memory_state.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

constexpr int kMapSide_px = 960;  // half of a full HD screen's width, and nearly its height

struct RecallOptions {
  std::string file;
  std::optional<std::uint64_t> cycle;
  std::string at;
  std::string image;
  bool json = false;
};

void print(const RecallOptions& options, const nlohmann::ordered_json& state) {
  if (options.json) {
    fmt::print("{}", agent::print_json(state));
    return;
  }
  try {
    fmt::print("{}", print_memory_state(state, terminal_width()));
  } catch (const nlohmann::json::exception&) {
    throw UserError(options.file + ": is damaged: not all of a memory is in it");
  }
}

/// Memory is what the cycles before have made of it: the recording is run again up to there.
int recall_recording(const RecallOptions& options) {
  std::optional<double> at_s;
  if (!options.at.empty()) at_s = parse_time_s("--at", options.at);
  agent::ReplayMission mission({options.file, {}, {}});
  std::uint64_t last = 0;
  bool found = false;
  while (!found && mission.step()) {
    last = mission.recorded().number;
    found = (options.cycle && last >= *options.cycle) ||
            (at_s && to_seconds(mission.recorded().senses.now) >= *at_s);
  }
  if (last == 0) throw UserError(options.file + ": has no cycle in it");
  if (!found && (options.cycle || at_s)) {
    throw UserError(fmt::format("{}: ends with cycle {} at {:.1f} s", options.file, last,
                                to_seconds(mission.recorded().senses.now)));
  }
  if (!options.image.empty()) {
    write_picture(options.image,
                  agent::pictures::draw_map(mission.cycle().memory(), mission.robot(),
                                            mission.trajectory(), kMapSide_px));
  }
  print(options, agent::memory_state(mission.cycle(), mission.executive(), last));
  return 0;
}

int run(const RecallOptions& options) {
  check_image_writable(options.image);
  if (replay::is_recording(options.file)) return recall_recording(options);
  const nlohmann::ordered_json state = agent::read_memory_state(options.file);
  if (options.cycle || !options.at.empty() || !options.image.empty()) {
    throw UserError(
        fmt::format("{}: is the memory of a mission as it is now; --cycle, --at and --picture go "
                    "with a recording",
                    options.file));
  }
  print(options, state);
  return 0;
}

}  // namespace

void add_recall_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RecallOptions>();
  CLI::App* command = app.add_subcommand(
      "recall",
      "Shows what short-term memory holds: polar map, salient regions, landmarks in mind, the\n"
      "corridor, the last commands; in any cycle of a recording, or now in a running mission.\n"
      "Examples: striate recall run.rec --at \"12.3 s\"\n"
      "          striate recall run.rec --cycle 123 --picture map.png\n"
      "          striate run TASK --world WORLD --inspect now.json & striate recall now.json");
  command
      ->add_option("file", options->file,
                   "a recording (striate run --record), or the file of striate run --inspect")
      ->required();
  CLI::Option* cycle = command
                           ->add_option("--cycle", options->cycle,
                                        "the cycle, from 1; the last where nothing is said")
                           ->check(whole_number_from(1));
  command->add_option("--at", options->at, "the first cycle from this time on: \"12.3 s\"")
      ->type_name("TIME")
      ->excludes(cycle);
  command->add_option("--picture", options->image, "writes the map from above (PNG)");
  command->add_flag("--json", options->json, "print JSON instead of text");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace striate::app
