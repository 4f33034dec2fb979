#pragma once

#include <limits>
#include <string>
#include <vector>

#include "striate/agent/run_result.hpp"

/// What stands below the table of a trial.
namespace striate::app {

/// A world's line of the table.
struct Row {
  std::string name;
  int runs = 0;
  int successes = 0;
  int touched = 0;
  int emergency_stops = 0;
  double time_s = 0.0;  ///< over the successful runs
  double distance_m = 0.0;
  double nearest_m = std::numeric_limits<double>::infinity();
  double longest_stand_s = 0.0;
};

/// Runs in which the robot stood for long, and why.
[[nodiscard]] std::string long_stands(const std::vector<agent::RunResult>& results);

/// What the world was to put into the way and did not: such a run shows nothing of how it is met.
[[nodiscard]] std::string never_put_down(const std::vector<agent::RunResult>& results);

/// Why runs failed.
[[nodiscard]] std::string causes(const std::vector<agent::RunResult>& results);

}  // namespace striate::app
