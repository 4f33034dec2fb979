#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "striate/app/command_line/found_file.hpp"
#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/app/trial/drawn_worlds.hpp"
#include "striate/app/trial/object_trial.hpp"
#include "striate/app/trial/trial.hpp"
#include "striate/app/trial/trial_merge.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/random_world/building_kind.hpp"

namespace striate::app {
namespace {

/// "2/3" as shard 2 of 3.
void read_shard(const std::string& text, TrialOptions& options) {
  if (text.empty()) return;
  int end = 0;
  const int count = std::sscanf(text.c_str(), "%d/%d%n", &options.shard, &options.shards, &end);
  if (count == 2 && end == static_cast<int>(text.size()) && options.shard >= 1 &&
      options.shard <= options.shards) {
    return;
  }
  throw UserError(
      fmt::format("'--shard {}' is no part of a whole\n    write 1/3, 2/3 or 3/3", text));
}

void add_merge(CLI::App& trial, int& exit_code) {
  auto folders = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>();
  CLI::App* merge = trial.add_subcommand(
      "merge",
      "Joins the shards of a trial into one table. Exit code 1 if runs of it are missing.\n"
      "Results do not say what --robot was: it is not compared, and the commands that show a\n"
      "failed run again have none; add it where the trial had it.");
  merge->add_option("folders", *folders, "the --out folders of the shards")
      ->type_name("FOLDER")
      ->required();
  merge->add_option("--out", *out, "folder for runs.csv and table.md of all")
      ->type_name("FOLDER")
      ->required();
  merge->callback([folders, out, &exit_code] {
    make_folder(*out);
    exit_code = merge_trials(*folders, *out);
  });
}

/// `--objects`: the worlds, where given, are the one to teach in and the one to seek in.
int run_objects(const TrialOptions& given, ObjectTrialOptions options) {
  if (!given.worlds.empty() && given.worlds.size() != 2) {
    throw UserError("--objects takes two worlds: one to teach in, one to seek in");
  }
  if (given.worlds.size() == 2) {
    options.teach_world = given.worlds[0];
    options.find_world = given.worlds[1];
  }
  if (!given.robot.empty()) options.robot = given.robot;
  for (std::string* task : {&options.task, &options.look_task}) find_task(*task);
  for (std::string* world : {&options.teach_world, &options.find_world}) find_world(*world);
  find_robot(options.robot);
  options.out = given.out;
  options.seed = given.first_seed;
  options.quiet = given.quiet;
  return run_object_trial(options);
}

void add_random_worlds(CLI::App& command, DrawnWorldsOptions& drawn) {
  CLI::Option* seeds =
      command
          .add_option("--random-worlds", drawn.seeds,
                      "instead of --worlds: the buildings that 'striate world --random' draws from "
                      "these seeds, e.g. 1..200; each is driven with its own seed")
          ->type_name("FROM..TO")
          ->excludes(command.get_option("--worlds"));
  command.add_option("--kind", drawn.kind, "of these buildings; without it one after the other")
      ->needs(seeds)
      ->check(CLI::IsMember(simulator::building_kinds()));
}

void check_given(const TrialOptions& options) {
  if (!options.worlds.empty() && !options.out.empty()) return;
  throw UserError(
      "a trial needs --worlds or --random-worlds, and --out\n"
      "    e.g. striate trial --worlds corridor_a --runs 20 --out out/trial");
}

}  // namespace

void add_trial_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TrialOptions>();
  auto no_emergency = std::make_shared<bool>(false);
  auto shard = std::make_shared<std::string>();
  auto objects = std::make_shared<ObjectTrialOptions>();
  auto of_objects = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(
      "trial",
      "Runs a mission many times in several worlds and prints the table of successes.\n"
      "A trial that was stopped goes on where it was when the same command is given again.\n"
      "Examples: striate trial --worlds corridor_a,corridor_b "
      "--runs 20 --jobs 2 --out out/trial\n"
      "          striate trial --random-worlds 1..200 --no-emergency --jobs 2 --out out/tuning");
  command->add_option("--worlds", options->worlds, "world files, separated by commas")
      ->delimiter(',');
  auto drawn = std::make_shared<DrawnWorldsOptions>();
  add_random_worlds(*command, *drawn);
  command->add_option("--task", options->task, "the task script")->capture_default_str();
  command->add_option("--robot", options->robot, "settings of the robot and its mind");
  const auto plugins = add_plugin_option(*command);
  command->add_option("--memory", options->memory,
                      "the long-term memory that each run begins with; a run works on a copy");
  command
      ->add_option("--runs", options->runs,
                   "runs of each world; each has its own seed; of a drawn world 1 unless said")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "how many runs at once")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--first-seed", options->first_seed, "seed of the first run")
      ->excludes(command->get_option("--random-worlds"))
      ->check(whole_number_from(0))
      ->capture_default_str();
  command->add_option("--out", options->out, "folder for runs.csv, table.md and the results")
      ->type_name("FOLDER");
  command
      ->add_option("--shard", *shard,
                   "i/n: only every n-th run, for n machines; 'striate trial merge' joins them")
      ->type_name("I/N");
  command->add_flag("--no-emergency", *no_emergency,
                    "sonar and laser do nothing: vision alone keeps the robot from touching");
  command
      ->add_option("--baseline", options->baseline,
                   "the same behaviours fed with other disparities: the paper's, OpenCV's SGBM or "
                   "the true ones; 'striate trial merge' puts them beside Striate's own")
      ->check(CLI::IsMember({"paper", "sgbm", "truth"}));
  command->add_flag("--quiet", options->quiet, "no progress bar");
  CLI::Option* instead = command->add_flag("--objects", *of_objects,
                                           "instead: teaches eight objects in one world and seeks "
                                           "them in another; --out is all it needs");
  for (const char* unused : {"--random-worlds", "--task", "--plugin", "--memory", "--runs",
                             "--jobs", "--shard", "--no-emergency", "--baseline"}) {
    instead->excludes(command->get_option(unused));
  }
  command->add_option("--only", objects->only, "with --objects: these, separated by commas")
      ->type_name("NAMES")
      ->needs(instead)
      ->delimiter(',');
  command->require_subcommand(0, 1);
  add_merge(*command, exit_code);
  command->callback([=, &exit_code] {
    if (!command->get_subcommands().empty()) return;  // merge has been run
    make_folder(options->out);
    if (*of_objects) {
      exit_code = run_objects(*options, *objects);
      return;
    }
    if (!drawn->seeds.empty()) {
      if (command->count("--runs") == 0) options->runs = 1;
      draw_trial_worlds(*drawn, *options);
    }
    check_given(*options);
    read_shard(*shard, *options);
    find_task(options->task);
    for (std::string& world : options->worlds) find_world(world);
    find_robot(options->robot);
    options->emergency_layer = !*no_emergency;
    options->plugins = *plugins;
    exit_code = run_trial(*options);
  });
}

}  // namespace striate::app
