#include <memory>
#include <string>

#include "striate/agent/plugins/plugin_body.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/run_mission.hpp"
#include "striate/app/plugin_option.hpp"

namespace striate::app {
namespace {

struct RunCommandOptions {
  RunOptions run;
  agent::WorldOptions world;
};

/// Without a world the robot is a real one, one behind a rosbridge server, or that of a plugin.
agent::BodySource body_for(const RunCommandOptions& options) {
  if (!options.world.world.empty()) return agent::simulated_pioneer(options.world);
  return agent::named_body(options.run.mission.robot);
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "run",
      "Runs a task script with the simulated Pioneer in a world, with a real one, or with a "
      "robot\nbehind a rosbridge server.\n"
      "Examples: striate run corridor --world corridor_a "
      "--seed 7 --result r.json\n"
      "          striate run corridor --robot pioneer "
      "--var \"way=20 m\"\n"
      "          striate run corridor --robot turtlebot_rosbridge "
      "--var \"way=20 m\"\n"
      "          striate run corridor --world corridor_a "
      "--real-time --foxglove\n"
      "Ctrl-C stops the robot, runs the task's 'finally' and still writes the result; a second "
      "one leaves 'finally' out, a third one ends the program at once, and the robot still stops.\n"
      "A robot that holds because the program stood still goes on after r and Enter, or the "
      "signal USR1.");
  command->add_option("task", options->run.mission.task, "the task script")->required();
  CLI::Option* world =
      command->add_option("--world", options->world.world,
                          "the world file; without it the robot is the one that --robot tells of");
  command->add_option("--robot", options->run.mission.robot, "settings of the robot and its mind");
  add_plugin_option(*command);
  command
      ->add_option("--seed", options->world.seed,
                   "start offset, people, noise, odometry: the same seed is the same run")
      ->check(whole_number_from(0))
      ->needs(world)
      ->capture_default_str();
  command->add_flag("--no-emergency", options->run.no_emergency,
                    "sonar and laser do nothing: vision alone keeps the robot from touching");
  CLI::Option* pictures = command
                              ->add_option("--pictures", options->run.pictures,
                                           "folder for overview images and the plan of the run")
                              ->needs(world)
                              ->type_name("FOLDER");
  command
      ->add_option("--picture-every", options->run.picture_every,
                   "an overview image every so many cycles; 0: none")
      ->check(CLI::Range(0, 1000000))
      ->needs(pictures);
  command->add_option("--result", options->run.result, "JSON file for what came of it");
  command->add_option("--memory", options->run.memory,
                      "the long-term memory that keeps what happens; made where there is none");
  command->add_option("--record", options->run.record,
                      "file for all that is felt and decided, for 'striate replay' and 'recall'");
  add_mcap_options(*command, options->run.mcap);
  add_foxglove_options(*command, options->run.foxglove, true);
  command
      ->add_flag("--real-time", options->run.real_time,
                 "the world goes no faster than the clock on the wall, for who looks on or drives")
      ->needs(world);
  command->add_option("--inspect", options->run.inspect,
                      "file that shows once a second what short-term memory holds, for "
                      "'striate recall'");
  command
      ->add_option("--baseline", options->world.baseline,
                   "drive by other disparities: the paper's, OpenCV's SGBM or the true ones")
      ->check(CLI::IsMember({"paper", "sgbm", "truth"}))
      ->needs(world);
  command
      ->add_option("--var", options->run.given,
                   "a variable of the task, as \"way=20 m\"; goes before what the world says")
      ->type_name("NAME=VALUE")
      ->take_all();
  command->add_flag("--quiet", options->run.quiet, "print nothing");
  command->add_flag("--json", options->run.json, "print the result as JSON instead of the summary");
  command->callback([options, &exit_code] {
    find_task(options->run.mission.task);
    find_robot(options->run.mission.robot);
    find_world(options->world.world);
    options->run.world = options->world.world;
    exit_code = run_mission(options->run, body_for(*options));
  });
}

}  // namespace striate::app
