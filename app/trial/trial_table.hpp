#pragma once

#include <string>
#include <vector>

#include "striate/agent/run_result.hpp"

namespace striate::app {

/// A 95 % interval of a success rate.
struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// Wilson's score interval: right also for 20 of 20.
[[nodiscard]] Interval wilson_interval(int successes, int runs);

/// `runs.csv`: one row a run, in the order given.
[[nodiscard]] std::string runs_csv(const std::vector<agent::RunResult>& results);

/// The table that `striate trial` prints: one row a world with the paper's figure beside it,
/// then the collisions by what was hit. Markdown, so that it can stand in a README.
[[nodiscard]] std::string trial_table(const std::vector<agent::RunResult>& results);

/// The command that runs it again, the same bit for bit, with images to watch. Parameters as below.
[[nodiscard]] std::string replay_command(const agent::RunResult& result, const std::string& robot,
                                         const std::string& memory = "",
                                         const std::vector<std::string>& plugins = {});

/// A command for each failed run that runs it again, the same bit for bit, with images to watch.
/// @param robot the settings file of the trial; may be empty, @param memory likewise.
/// @param plugins that each run was given
[[nodiscard]] std::string replay_commands(const std::vector<agent::RunResult>& results,
                                          const std::string& robot, const std::string& memory = "",
                                          const std::vector<std::string>& plugins = {});

}  // namespace striate::app
