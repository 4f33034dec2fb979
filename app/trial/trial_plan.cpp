#include "striate/app/trial/trial_plan.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace striate::app {

std::string world_name(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

std::string row_name(const std::string& file, const std::string& baseline) {
  return world_name(file) + (baseline.empty() ? "" : ", " + baseline);
}

std::vector<TrialRun> plan_trial(const TrialOptions& options) {
  std::vector<TrialRun> runs;
  int number = 0;
  for (std::size_t which = 0; which < options.worlds.size(); ++which) {
    const std::string& world = options.worlds[which];
    const std::uint64_t first =
        options.world_seeds.empty() ? options.first_seed : options.world_seeds[which];
    for (int i = 0; i < options.runs; ++i) {
      if (number++ % options.shards != options.shard - 1) continue;
      const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
      const std::string file =
          fmt::format("{}/runs/{}_seed{:03d}.json", options.out, world_name(world), seed);
      runs.push_back({world, seed, file});
    }
  }
  return runs;
}

std::vector<std::string> command_of(const TrialRun& run, const TrialOptions& options,
                                    const std::string& program) {
  std::vector<std::string> command = {program,
                                      "run",
                                      options.task,
                                      "--world",
                                      run.world,
                                      "--seed",
                                      fmt::format("{}", run.seed),
                                      "--quiet",
                                      "--result",
                                      run.result_file};
  if (!options.emergency_layer) command.emplace_back("--no-emergency");
  if (!options.baseline.empty()) {
    command.emplace_back("--baseline");
    command.push_back(options.baseline);
  }
  if (!options.robot.empty()) {
    command.emplace_back("--robot");
    command.push_back(options.robot);
  }
  for (const std::string& plugin : options.plugins) {
    command.emplace_back("--plugin");
    command.push_back(plugin);
  }
  if (!options.memory.empty()) {
    command.emplace_back("--memory");
    command.push_back(memory_of(run));
  }
  return command;
}

std::string memory_of(const TrialRun& run) {
  return std::filesystem::path(run.result_file).replace_extension(".db").string();
}

}  // namespace striate::app
