#include "striate/app/trial/trial_notes.hpp"

#include <fmt/format.h>

#include <map>

#include "striate/app/trial/trial_plan.hpp"

namespace striate::app {
namespace {

std::string without_number(std::string name) {
  while (!name.empty() && (std::isdigit(static_cast<unsigned char>(name.back())) != 0 ||
                           name.back() == ' ' || name.back() == '_')) {
    name.pop_back();
  }
  return name;
}

}  // namespace

std::string long_stands(const std::vector<agent::RunResult>& results) {
  // s: a person who watches takes so long a stand for the end of the run (ours)
  constexpr double kLong_s = 30.0;
  std::string text;
  for (const agent::RunResult& result : results) {
    if (result.longest_stand_s <= kLong_s) continue;
    text += fmt::format("- {} seed {}, {:.0f} s{}\n", world_name(result.world), result.seed,
                        result.longest_stand_s, agent::stood_for(result));
  }
  return text;
}

std::string never_put_down(const std::vector<agent::RunResult>& results) {
  std::string text;
  for (const agent::RunResult& result : results) {
    for (const agent::LateObstacleRecord& late : result.late_obstacles) {
      if (late.time_s) continue;
      text += fmt::format("- {} seed {}: {}\n", world_name(result.world), result.seed, late.name);
    }
  }
  return text;
}

std::string causes(const std::vector<agent::RunResult>& results) {
  std::map<std::string, int> counts;
  for (const agent::RunResult& result : results) {
    if (result.outcome == agent::RunOutcome::success) continue;
    if (result.collisions.empty()) {
      ++counts[fmt::format("{}: {}", name_of(result.outcome), result.reason)];
      continue;
    }
    const agent::CollisionRecord& hit = result.collisions.front();
    const char* light = hit.light_level < 0.3 ? "in the dark" : "in light";
    constexpr std::string_view kFell = "drop of ";  // as the judge says it
    if (hit.hit.rfind(kFell, 0) == 0) {
      ++counts[fmt::format("fell down {}, {}", without_number(hit.hit.substr(kFell.size())),
                           light)];
      continue;
    }
    ++counts[fmt::format("touched {}, {}, {}", without_number(hit.hit),
                         hit.moving ? "moving" : "still", light)];
  }
  std::string text;
  for (const auto& [cause, count] : counts) text += fmt::format("- {} x {}\n", count, cause);
  return text;
}

}  // namespace striate::app
