#include "striate/app/trial/trial_merge.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "striate/agent/run_result.hpp"
#include "striate/app/trial/trial_plan.hpp"
#include "striate/app/trial/trial_table.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/random_world/random_world.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;

/// World with its baseline, then seed: the order of the table.
using Key = std::pair<std::string, std::uint64_t>;

struct RunFound {
  agent::RunResult result;
  std::string file;
};

agent::RunResult read_run(const fs::path& file) {
  std::ifstream stream(file);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  try {
    if (!json.is_discarded()) return agent::run_result_from_json(json);
  } catch (const std::runtime_error&) {
  }
  throw UserError(fmt::format("{}: not the result of a run", file.string()));
}

/// What must be the same for one figure: the same run, or another one of the same trial.
void check_same_trial(const RunFound& first, const RunFound& other) {
  if (first.result.task == other.result.task &&
      first.result.emergency_layer == other.result.emergency_layer) {
    return;
  }
  throw UserError(
      fmt::format("{} and {} are of different trials\n"
                  "    task or emergency layer differ; merge those that belong together",
                  first.file, other.file));
}

using Runs = std::map<Key, RunFound>;

/// Of a world in a trial: a row with more is a typing error
constexpr std::uint64_t kMostRuns = 10000;

/// The runs of a drawn building begin with its own seed: with that they are counted from 0 here.
std::uint64_t first_seed_of(const std::string& world) {
  const auto drawn = simulator::drawn_from(world_name(world.substr(0, world.find(", "))));
  return drawn ? drawn->seed : 0;
}

/// Runs that came to no end, and holes: a trial gives every world the same seeds in a row, every
/// drawn building as many from its own on.
std::set<Key> missing_runs(const Runs& all, std::set<Key> unfinished) {
  std::map<std::string, std::uint64_t> worlds;  // with what their seeds count from
  std::set<std::uint64_t> seeds;
  const auto note = [&](const Key& key) {
    const std::uint64_t first = worlds.emplace(key.first, first_seed_of(key.first)).first->second;
    seeds.insert(key.second - first);
  };
  for (const auto& [key, found] : all) note(key);
  for (const Key& key : unfinished) note(key);
  if (!seeds.empty() && *seeds.rbegin() - *seeds.begin() < kMostRuns) {
    const std::uint64_t last = *seeds.rbegin();
    for (std::uint64_t seed = *seeds.begin(); seed != last; ++seed) seeds.insert(seed);
  }
  for (const auto& [world, first] : worlds) {
    for (const std::uint64_t seed : seeds) unfinished.insert({world, first + seed});
  }
  for (const auto& [key, found] : all) unfinished.erase(key);
  return unfinished;
}

void take_folder(const std::string& folder, Runs& all, std::set<Key>& unfinished) {
  std::error_code code;
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder + "/runs", code)) {
    if (entry.path().extension() != ".json") continue;
    RunFound found{read_run(entry.path()), entry.path().string()};
    ++count;
    const Key key{found.result.baseline.empty() ? found.result.world
                                                : found.result.world + ", " + found.result.baseline,
                  found.result.seed};
    if (!agent::row_of(found.result.outcome).finished) {
      unfinished.insert(key);
      continue;
    }
    if (!all.empty()) check_same_trial(all.begin()->second, found);
    const auto [place, is_new] = all.emplace(key, found);
    if (is_new || place->second.result.outcome == found.result.outcome) continue;
    throw UserError(fmt::format("{} and {} tell different things of the same run",
                                place->second.file, found.file));
  }
  if (count == 0) {
    throw UserError(
        fmt::format("{}: holds no runs\n    give the --out folders of 'striate trial'", folder));
  }
}

}  // namespace

int merge_trials(const std::vector<std::string>& folders, const std::string& out) {
  Runs all;
  std::set<Key> unfinished;
  for (const std::string& folder : folders) take_folder(folder, all, unfinished);
  const std::set<Key> missing = missing_runs(all, unfinished);
  std::vector<agent::RunResult> results;
  for (auto& [key, found] : all) results.push_back(std::move(found.result));
  write_file(out + "/runs.csv", runs_csv(results));
  write_file(out + "/table.md", trial_table(results));
  fmt::print("{}{}", trial_table(results), replay_commands(results, ""));
  if (missing.empty()) return 0;
  fmt::print(stderr, "{} runs are not in the table: interrupted, lost or without a result\n",
             missing.size());
  for (const auto& [world, seed] : missing) fmt::print(stderr, "  {} seed {}\n", world, seed);
  return 1;
}

}  // namespace striate::app
