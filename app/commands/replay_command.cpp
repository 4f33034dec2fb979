#include <fmt/format.h>

#include <memory>
#include <thread>

#include "striate/agent/pictures/cycle_sheet.hpp"
#include "striate/agent/replay/replay_mission.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/compare_replays.hpp"
#include "striate/app/commands/foxglove_options.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/pace.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/viewer/foxglove/mission_foxglove.hpp"

namespace striate::app {
namespace {

struct ReplayCommandOptions {
  agent::ReplayOptions replay;
  int picture_every = 0;  // cycles between images; 0: none
  std::string pictures;
  FoxgloveOptions foxglove;
  double speed = 1.0;  // of what is shown; 0: as fast as it can
  bool json = false;
};

void take_image(const agent::ReplayMission& mission, const ReplayCommandOptions& options) {
  if (options.picture_every <= 0 || options.pictures.empty()) return;
  const std::uint64_t number = mission.recorded().number;
  if (number % static_cast<unsigned>(options.picture_every) != 0) return;
  if (!mission.cycle().trace().percept.valid) return;
  const std::string caption = agent::pictures::cycle_caption(
      mission.cycle(), mission.cycle().memory().progress_m(), mission.executive().current_action());
  write_picture(fmt::format("{}/overview_{:05d}.png", options.pictures, number),
                agent::pictures::draw_cycle_sheet(mission.cycle(), mission.robot(),
                                                  mission.trajectory(), caption));
}

/// A recording as it is shown: at a speed that eyes can follow, and held where a viewer pauses it.
class ShownReplay {
 public:
  ShownReplay(const ReplayCommandOptions& options, const agent::ReplayMission& mission)
      : shown_(options.foxglove.wanted()), pace_(shown_ ? options.speed : 0.0) {
    if (!shown_) return;
    foxglove_.begin(options.foxglove.for_server(), mission);
    say(stderr, options.foxglove.addresses(foxglove_.url(), foxglove_.page_url()));
  }
  /// @return false where somebody wants it to end
  bool show(const agent::ReplayMission& mission) {
    if (!shown_) return true;
    foxglove_.take(mission);
    const TimePoint at = mission.recorded().senses.now;
    std::this_thread::sleep_until(pace_.due(at, Pace::Steady::now()));
    while (foxglove_.paused() && goes_on()) std::this_thread::sleep_for(kLookAgain);
    return goes_on();
  }
  void finish() { foxglove_.finish(); }

 private:
  /// By hand: a person does not notice it
  static constexpr auto kLookAgain = std::chrono::milliseconds(20);
  [[nodiscard]] bool goes_on() const { return !Interrupt::requested() && !foxglove_.stop_asked(); }

  bool shown_;
  viewer::MissionFoxglove foxglove_;
  Pace pace_;
};

int run(const ReplayCommandOptions& options) {
  make_folder(options.pictures);
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  agent::ReplayMission mission(options.replay);
  Comparison result;
  ShownReplay shown(options, mission);
  bool goes_on = true;
  while (goes_on && !Interrupt::requested() && mission.step()) {
    compare(mission, result);
    take_image(mission, options);
    goes_on = shown.show(mission);
  }
  shown.finish();
  if (options.json) {
    print_as_json(mission, result);
  } else {
    print_text(mission, result);
  }
  if (Interrupt::requested() || !goes_on) return 130;
  return result.identical() ? 0 : 1;
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ReplayCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "replay",
      "Runs a recording (striate run --record) again through seeing, memory, task and behaviours,\n"
      "and compares every wish and command with those of then, bit for bit.\n"
      "Examples: striate replay run.rec\n"
      "          striate replay run.rec --robot other.yaml --pictures out/replay "
      "--picture-every 10\n"
      "          striate replay run.rec --foxglove\n"
      "Exit code 0: all the same; 1: something was decided otherwise, and it says where first,\n"
      "or the recording holds no cycle.");
  command->add_option("recording", options->replay.recording, "the recording")->required();
  command->add_option("--robot", options->replay.robot,
                      "other settings than those of the recording");
  command->add_option("--task", options->replay.task, "another task than that of the recording");
  add_plugin_option(*command);
  CLI::Option* pictures =
      command->add_option("--pictures", options->pictures, "folder for overview images")
          ->type_name("FOLDER");
  command
      ->add_option("--picture-every", options->picture_every,
                   "an overview image every so many cycles; 0: none")
      ->check(CLI::Range(0, 1000000))
      ->needs(pictures);
  pictures->needs("--picture-every");
  add_foxglove_options(*command, options->foxglove, false);
  command
      ->add_option("--speed", options->speed,
                   "of what is shown: 1 as it was, 2 twice as fast; 0: as fast as it can")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  command->add_flag("--json", options->json, "print JSON instead of text");
  command->callback([options, &exit_code] {
    find_robot(options->replay.robot);
    find_task(options->replay.task);
    exit_code = run(*options);
  });
}

}  // namespace striate::app
