#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace striate::app {

/// What `striate trial` is asked for.
struct TrialOptions {
  std::vector<std::string> worlds;
  /// Of each world the seed of its first run, where they differ; empty: `first_seed` for all.
  std::vector<std::uint64_t> world_seeds;
  std::string task = "config/tasks/corridor.yaml";
  std::string robot;   ///< settings file; empty: the built-in defaults
  std::string memory;  ///< what each run begins with, in a copy of its own; empty: none
  std::vector<std::string> plugins;  ///< shared objects that each run is given
  int runs = 20;                     ///< of each world
  int jobs = 1;                      ///< how many at once
  std::uint64_t first_seed = 1;      ///< of a series of runs
  bool emergency_layer = true;
  std::string baseline;  ///< see MissionOptions
  std::string out;
  int shard = 1;   ///< which part of the runs, 1 .. shards
  int shards = 1;  ///< over how many machines they are split
  bool quiet = false;
};

/// One run of a trial.
struct TrialRun {
  std::string world;
  std::uint64_t seed = 0;
  std::string result_file;  ///< JSON, written by the run itself
};

/// All runs of this shard in the order of the table: worlds as named, seeds upwards. Every n-th run
/// is the shard's, so that each machine has its share of each world.
[[nodiscard]] std::vector<TrialRun> plan_trial(const TrialOptions& options);

/// The command line of one run, program first.
[[nodiscard]] std::vector<std::string> command_of(const TrialRun& run, const TrialOptions& options,
                                                  const std::string& program);

/// The copy of the memory that a run works with; it stays beside the run's result.
[[nodiscard]] std::string memory_of(const TrialRun& run);

/// "corridor_a", and "corridor_a, sgbm" with a baseline: the name of a row of the table.
[[nodiscard]] std::string row_name(const std::string& file, const std::string& baseline);

/// "corridor_a" from "config/worlds/corridor_a.yaml".
[[nodiscard]] std::string world_name(const std::string& file);

}  // namespace striate::app
