#include <fmt/format.h>

#include <memory>
#include <string>

#include "app/commands/commands.hpp"
#include "app/commands/run_on_robot.hpp"
#include "app/files.hpp"
#include "app/interrupt.hpp"
#include "app/memory/landmark_knowledge.hpp"
#include "app/mission.hpp"
#include "app/mission_memory.hpp"
#include "app/mission_pictures.hpp"
#include "app/recall/live_memory.hpp"
#include "app/recording/mission_recorder.hpp"
#include "app/status_line.hpp"
#include "config/user_error.hpp"

namespace striate {
namespace {

struct RunOptions {
  MissionOptions mission;
  bool no_emergency = false;
  int picture_every = 0;  // cycles between pictures; 0: none
  std::string pictures;
  std::string result;
  std::string memory;
  std::string record;
  std::string inspect;
  std::vector<std::string> given;
  bool quiet = false;
  bool json = false;
};

std::string status_text(const Mission& mission) {
  const CognitiveCycle& cycle = mission.cycle();
  const CycleTrace& trace = cycle.trace();
  return fmt::format(
      "{:5.1f} s  {:5.1f} m  {:.2f} m/s  {:.1f} ms a cycle  {:4.1f} x real time  {}: {}",
      to_seconds(trace.senses.now), cycle.memory().progress_m(), trace.senses.odometry.forward_m_s,
      mission.mean_cycle_ms(), mission.realtime_factor(), mission.executive().current_action(),
      doing_text(trace.wish.why, trace.limited_by));
}

/// What the task says is shown once, as a line that stays.
void tell_what_is_said(const Mission& mission, std::string& said, StatusLine& status) {
  if (mission.executive().current_action() != "say") {
    said.clear();
    return;
  }
  const std::string_view words = mission.cycle().trace().wish.why.view();
  if (words == said) return;
  said = words;
  status.tell(said);
}

void print_summary(const RunResult& result, const RunOptions& options) {
  fmt::print("{} in {}, seed {}: {}{}\n", result.task, result.world, result.seed, result.outcome,
             result.reason.empty() ? "" : " (" + result.reason + ")");
  fmt::print("  goal reached      {}\n", result.reached_goal ? "yes" : "no");
  fmt::print("  driven            {:.1f} m in {:.0f} s ({:.2f} m/s)\n", result.distance_m,
             result.duration_s, result.distance_m / std::max(result.duration_s, 0.1));
  fmt::print("  nearest pass      {:.2f} m\n", result.nearest_pass_m);
  fmt::print("  emergency stops   {}{}\n", result.emergency_stops,
             result.emergency_layer ? "" : " (sonar and laser are off)");
  if (result.from_start_m) {
    fmt::print("  ends              {:.2f} m from the start\n", *result.from_start_m);
  }
  fmt::print("  longest stand     {:.0f} s{}\n", result.longest_stand_s, stood_for(result));
  fmt::print("  collisions        {}\n", result.collisions.size());
  for (const CollisionRecord& hit : result.collisions) {
    fmt::print("    {:.1f} s: {} ({}) at {:.1f} m, {:+.2f} m, light {:.2f}\n", hit.time_s, hit.hit,
               hit.moving ? "moving" : "still", hit.along_m, hit.left_m, hit.light_level);
  }
  fmt::print("  thinking          {:.1f} ms a cycle, {:.1f} times real time in all\n",
             result.mean_cycle_ms, result.realtime_factor);
  if (!options.result.empty()) fmt::print("  record            {}\n", options.result);
  if (!options.pictures.empty()) fmt::print("  pictures          {}\n", options.pictures);
}

int run(const RunOptions& given) {
  RunOptions options = given;
  if (!options.memory.empty()) options.mission.knowledge = read_mission_knowledge(options.memory);
  options.mission.emergency_layer = !options.no_emergency;
  if (!options.result.empty()) check_writable(options.result);
  const Interrupt interrupt;
  MissionRecorder recorder(options.record, options.memory);
  Mission mission(options.mission);
  MissionPictures pictures(options.pictures, options.picture_every);
  MissionMemory memory(options.memory, options.mission.robot,
                       fmt::format("{} in {}, seed {}", options.mission.task, options.mission.world,
                                   options.mission.seed));
  recorder.begin(mission);
  LiveMemory live(options.inspect);
  StatusLine status(options.quiet || options.json);
  std::string said;
  const RunResult result = mission.run([&](const Mission& running) {
    recorder.take(running.cycle(), running.executive());
    live.take(running.cycle(), running.executive(), running.cycles());
    pictures.take(running);
    tell_what_is_said(running, said, status);
    memory.take(mission.cycle());
    memory.take(mission.body().judge());
    if (status.due()) status.show(status_text(running));
    return Interrupt::requested();
  });
  status.clear();
  const std::string recorded = recorder.finish();
  live.finish();
  memory.finish(mission.cycle(), result);
  pictures.finish(mission, result);
  const std::string json = to_json(result).dump(2) + "\n";
  if (!options.result.empty()) write_file(options.result, json);
  if (options.json) {
    fmt::print("{}", json);
  } else if (!options.quiet) {
    print_summary(result, options);
    if (!recorded.empty()) fmt::print("  recording         {}\n", recorded);
  }
  return exit_code_of(result);
}

/// Without a world the robot is a real one.
int run_with_robot(const RunOptions& options) {
  if (!options.pictures.empty()) throw UserError("striate run: --pictures goes with --world");
  RunOnRobotOptions real;
  real.mission.task = options.mission.task;
  real.mission.robot = options.mission.robot;
  real.mission.emergency_layer = !options.no_emergency;
  real.given = options.given;
  real.memory = options.memory;
  real.record = options.record;
  real.inspect = options.inspect;
  real.result = options.result;
  real.quiet = options.quiet;
  real.json = options.json;
  return run_on_robot(real);
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand(
      "run",
      "Runs a task script with the simulated Pioneer in a world, or with a real one.\n"
      "Examples: striate run config/tasks/corridor.yaml --world config/worlds/corridor_a.yaml "
      "--seed 7 --result r.json\n"
      "          striate run config/tasks/corridor.yaml --robot config/robots/pioneer.yaml "
      "--var \"way=20 m\"\n"
      "Ctrl-C stops the robot, runs the task's 'finally' and still writes the result.");
  command->add_option("task", options->mission.task, "the task script")->required();
  command->add_option("--world", options->mission.world,
                      "the world file; without it the robot is the one that --robot tells of");
  command->add_option("--robot", options->mission.robot, "settings of the robot and its mind");
  command
      ->add_option("--seed", options->mission.seed,
                   "start offset, people, noise, odometry: the same seed is the same run")
      ->capture_default_str();
  command->add_flag("--no-emergency", options->no_emergency,
                    "sonar and laser do nothing: vision alone keeps the robot from touching");
  command
      ->add_option("--picture-every", options->picture_every,
                   "an overview picture every so many cycles; 0: none")
      ->check(CLI::Range(0, 1000000));
  command->add_option("--pictures", options->pictures,
                      "folder for overview pictures and the plan of the run");
  command->add_option("--result", options->result, "JSON file for what came of it");
  command->add_option("--memory", options->memory,
                      "the long-term memory that keeps what happens; made where there is none");
  command->add_option("--record", options->record,
                      "file for all that is felt and decided, for 'striate replay' and 'recall'");
  command->add_option("--inspect", options->inspect,
                      "file that shows once a second what short-term memory holds, for "
                      "'striate recall'");
  command->add_option("--baseline", options->mission.baseline,
                      "drive by other disparities: paper, sgbm (OpenCV's) or truth");
  command
      ->add_option("--var", options->given,
                   "a variable of the task, as \"way=20 m\", for a run without a world")
      ->take_all();
  command->add_flag("--quiet", options->quiet, "print nothing");
  command->add_flag("--json", options->json, "print the result as JSON instead of the summary");
  command->callback([options, &exit_code] {
    if (!options->mission.world.empty() && !options->given.empty()) {
      throw UserError("striate run: --var goes without --world: the world says how far to drive");
    }
    exit_code = options->mission.world.empty() ? run_with_robot(*options) : run(*options);
  });
}

}  // namespace striate
