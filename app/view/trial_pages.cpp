#include "striate/app/view/trial_pages.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <tuple>

#include "striate/agent/run_result.hpp"
#include "striate/app/trial/trial_plan.hpp"
#include "striate/app/trial/trial_table.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;

struct KeptRun {
  std::string file;
  agent::RunResult result;
};

std::optional<agent::RunResult> kept_result(const fs::path& file) {
  std::ifstream stream(file);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  try {
    return agent::run_result_from_json(json);
  } catch (const std::exception&) {  // half written, or something else
    return std::nullopt;
  }
}

/// By world and seed, as the table has them.
std::vector<KeptRun> kept_runs(const std::string& folder) {
  std::vector<KeptRun> runs;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::path(folder) / "runs", error)) {
    if (entry.path().extension() != ".json") continue;
    if (const auto result = kept_result(entry.path())) {
      runs.push_back({entry.path().filename().string(), *result});
    }
  }
  std::sort(runs.begin(), runs.end(), [](const KeptRun& a, const KeptRun& b) {
    return std::tie(a.result.world, a.result.seed, a.file) <
           std::tie(b.result.world, b.result.seed, b.file);
  });
  return runs;
}

nlohmann::ordered_json trials_json(const std::string& folder) {
  nlohmann::ordered_json json = {{"folder", folder}, {"runs", nlohmann::ordered_json::array()}};
  std::vector<agent::RunResult> results;
  for (const KeptRun& run : kept_runs(folder)) {
    results.push_back(run.result);
    nlohmann::ordered_json one = agent::to_json(run.result);
    one["file"] = run.file;
    one["name"] = row_name(run.result.world, run.result.baseline);
    one["in_words"] = agent::outcome_text(run.result);
    one["command"] = replay_command(run.result, "");
    json["runs"].push_back(one);
  }
  json["table"] = trial_table(results);
  return json;
}

}  // namespace

bool is_trial_folder(const std::string& folder) {
  return fs::is_directory(fs::path(folder) / "runs");
}

void add_trial_pages(viewer::dashboard::Site& site, const std::string& folder) {
  site.on_get("/api/trials", [folder](const viewer::dashboard::HttpRequest&) {
    return viewer::dashboard::json_answer(trials_json(folder));
  });
}

}  // namespace striate::app
