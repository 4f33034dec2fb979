#include "app/trial/trial_merge.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

#include "app/run_result.hpp"
#include "app/trial/trial_table.hpp"
#include "config/user_error.hpp"

namespace striate {
namespace {

namespace fs = std::filesystem;

/// World, then seed: the order of the table.
using Key = std::pair<std::string, std::uint64_t>;

struct Found {
  RunResult result;
  std::string file;
};

RunResult read_run(const fs::path& file) {
  std::ifstream stream(file);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  try {
    if (!json.is_discarded()) return run_result_from_json(json);
  } catch (const std::runtime_error&) {
  }
  throw UserError(fmt::format("{}: not the result of a run", file.string()));
}

/// What must be the same for one figure: the same run, or another one of the same trial.
void check_same_trial(const Found& first, const Found& other) {
  if (first.result.task == other.result.task &&
      first.result.emergency_layer == other.result.emergency_layer) {
    return;
  }
  throw UserError(
      fmt::format("{} and {} are of different trials\n"
                  "    task or emergency layer differ; merge those that belong together",
                  first.file, other.file));
}

void take_folder(const std::string& folder, std::map<Key, Found>& all) {
  std::error_code code;
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder + "/runs", code)) {
    if (entry.path().extension() != ".json") continue;
    Found found{read_run(entry.path()), entry.path().string()};
    ++count;
    if (found.result.outcome == "interrupted" || found.result.outcome == "lost") continue;
    if (!all.empty()) check_same_trial(all.begin()->second, found);
    const Key key{found.result.world, found.result.seed};
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
  std::map<Key, Found> all;
  for (const std::string& folder : folders) take_folder(folder, all);
  std::vector<RunResult> results;
  for (auto& [key, found] : all) results.push_back(std::move(found.result));
  write_file(out + "/runs.csv", runs_csv(results));
  write_file(out + "/table.md", trial_table(results));
  fmt::print("{}{}", trial_table(results), replay_commands(results, ""));
  return 0;
}

}  // namespace striate
