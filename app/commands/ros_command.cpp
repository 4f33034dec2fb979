#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "striate/agent/simulated_body.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/run_mission.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#ifdef STRIATE_HAS_ROS
#include "striate/agent/ros/ros_bodies.hpp"
#include "striate/agent/ros/tell_ros.hpp"
#include "striate/app/ros/replay_bag.hpp"
#endif

namespace striate::app {
namespace {

struct RosOptions {
  RunOptions run;
  agent::WorldOptions world;
};

struct BagOptions {
  std::string bag;
  std::string robot;
  std::string camera;
  std::string out;
  int picture_every = 0;  // cycles between images; 0: none
};

#ifdef STRIATE_HAS_ROS

int run_and_tell(RosOptions& options, const agent::BodySource& body, ros::Tells tells,
                 bool cmd_vel_drives) {
  std::unique_ptr<agent::TellRos> ros;
  options.run.at_begin = [&](agent::Mission& mission) {
    ros = std::make_unique<agent::TellRos>(mission, tells);
    if (cmd_vel_drives) {
      const double tilt_rad = mission.body().description().resting_tilt_rad;
      mission.set_pilot(agent::cmd_vel_pilot(mission.settings().ros, tilt_rad));
    }
    if (options.run.quiet || options.run.json) return;
    say(stdout, "on ROS; Ctrl-C ends it, a second one without the task's 'finally'\n");
  };
  options.run.each_cycle = [&](const agent::Mission& mission) { ros->tell(mission); };
  return run_mission(options.run, body);
}

int serve(RosOptions& options) {
  const agent::BodySource body = options.world.world.empty()
                                     ? agent::real_pioneer()
                                     : agent::pioneer_in_real_time(options.world);
  return run_and_tell(options, body, ros::Tells::body_and_mind, true);
}

int run(RosOptions& options) {
  return run_and_tell(options, agent::robot_behind_ros(), ros::Tells::mind, false);
}

int replay(const BagOptions& options) {
  return replay_bag(
      {options.bag, options.robot, options.camera, options.out, options.picture_every});
}

#else

[[noreturn]] int serve(RosOptions&) {
  throw UserError(
      "striate ros: this build is without ROS 1\n"
      "  hint: install the packages of cmake/packages_ros.txt and build anew");
}

[[noreturn]] int run(RosOptions& options) {
  serve(options);
}

[[noreturn]] int replay(const BagOptions&) {
  RosOptions none;
  serve(none);
}

#endif

void find_files(RosOptions& options) {
  find_task(options.run.mission.task);
  find_robot(options.run.mission.robot);
  find_world(options.world.world);
  options.run.world = options.world.world;
}

void add_common(CLI::App& command, RosOptions& options) {
  command.add_option("--robot", options.run.mission.robot,
                     "settings; the section 'ros' names topics and frames");
  add_plugin_option(command);
  command.add_option("--var", options.run.given, "a variable of the task, as \"way=20 m\"")
      ->type_name("NAME=VALUE")
      ->take_all();
  command.add_option("--memory", options.run.memory,
                     "the long-term memory that keeps what happens; made where there is none");
  command.add_option("--result", options.run.result, "JSON file for what came of it");
  command.add_flag("--no-emergency", options.run.no_emergency, "sonar and laser do nothing");
  command.add_flag("--quiet", options.run.quiet, "print nothing");
  command.add_flag("--json", options.run.json, "print the result as JSON instead of the summary");
}

void add_serve(CLI::App& ros, const std::shared_ptr<RosOptions>& options, int& exit_code) {
  CLI::App* command = ros.add_subcommand(
      "serve",
      "Runs a robot and shows it to ROS: odometry, tf, images, disparity, scan, sonar, joints,\n"
      "diagnostics. cmd_vel goes before the task while it is not older than 500 ms.\n"
      "Examples: striate ros serve --world corridor_a\n"
      "          striate ros serve corridor --robot pioneer");
  command->add_option("task", options->run.mission.task,
                      "what the robot does by itself; without it, it stands");
  CLI::Option* world = command->add_option(
      "--world", options->world.world,
      "the simulated Pioneer in this world, in real time; without it the robot is the one that "
      "--robot tells of");
  command->add_option("--seed", options->world.seed, "of the world")
      ->check(whole_number_from(0))
      ->needs(world)
      ->capture_default_str();
  add_common(*command, *options);
  command->callback([options, &exit_code] {
    find_files(*options);
    exit_code = serve(*options);
  });
}

void add_run(CLI::App& ros, const std::shared_ptr<RosOptions>& options, int& exit_code) {
  CLI::App* command =
      ros.add_subcommand("run",
                         "Runs a task on a robot that is only reachable through ROS: stereo "
                         "images and odometry come\n"
                         "as topics, cmd_vel goes out.\n"
                         "Example: striate ros run corridor --var \"way=20 m\"");
  command->add_option("task", options->run.mission.task, "the task script")->required();
  add_common(*command, *options);
  command->callback([options, &exit_code] {
    find_files(*options);
    exit_code = run(*options);
  });
}

void add_replay(CLI::App& ros, int& exit_code) {
  auto options = std::make_shared<BagOptions>();
  CLI::App* command = ros.add_subcommand(
      "replay",
      "Looks at the stereo images of a ROS bag with the whole cycle; needs no ROS master.\n"
      "Example: striate ros replay drive.bag --out out/drive --picture-every 10");
  command->add_option("bag", options->bag, "the bag")->required();
  command->add_option("--robot", options->robot,
                      "settings; the section 'ros' names topics where they are not found");
  add_plugin_option(*command);
  command
      ->add_option("--camera", options->camera,
                   "what the topics of its eyes begin with, where the bag has several stereo "
                   "cameras")
      ->type_name("TOPIC");
  CLI::Option* out = command
                         ->add_option("--out", options->out,
                                      "folder for percepts.jsonl, one line an image pair, and "
                                      "pictures")
                         ->type_name("FOLDER");
  command
      ->add_option("--picture-every", options->picture_every,
                   "an overview image every so many image pairs; 0: none")
      ->check(CLI::Range(0, 1000000))
      ->needs(out);
  command->callback([options, &exit_code] {
    make_folder(options->out);
    find_robot(options->robot);
    exit_code = replay(*options);
  });
}

}  // namespace

void add_ros_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "ros", "Shows a robot to ROS 1, drives one through it, or looks at a bag.");
  command->require_subcommand(1);
  add_serve(*command, std::make_shared<RosOptions>(), exit_code);
  add_run(*command, std::make_shared<RosOptions>(), exit_code);
  add_replay(*command, exit_code);
}

}  // namespace striate::app
