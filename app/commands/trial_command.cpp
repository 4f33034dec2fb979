#include <memory>

#include "app/commands/commands.hpp"
#include "app/trial/trial.hpp"

namespace striate {

void add_trial_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TrialOptions>();
  auto no_emergency = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(
      "trial",
      "Runs a mission many times in several worlds and prints the table of successes.\n"
      "A trial that was stopped goes on where it was when the same command is given again.\n"
      "Example: striate trial --worlds config/worlds/corridor_a.yaml,config/worlds/corridor_b.yaml "
      "--runs 20 --jobs 2 --out out/trial");
  command->add_option("--worlds", options->worlds, "world files, separated by commas")
      ->required()
      ->delimiter(',');
  command->add_option("--task", options->task, "the task script")->capture_default_str();
  command->add_option("--robot", options->robot, "settings of the robot and its mind");
  command->add_option("--runs", options->runs, "runs of each world; each has its own seed")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "how many runs at once")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--first-seed", options->first_seed, "seed of the first run")
      ->capture_default_str();
  command->add_option("--out", options->out, "folder for runs.csv, table.md and the results")
      ->required();
  command->add_flag("--no-emergency", *no_emergency,
                    "sonar and laser do nothing: vision alone keeps the robot from touching");
  command->add_flag("--quiet", options->quiet, "no progress bar");
  command->callback([options, no_emergency, &exit_code] {
    options->emergency_layer = !*no_emergency;
    exit_code = run_trial(*options);
  });
}

}  // namespace striate
