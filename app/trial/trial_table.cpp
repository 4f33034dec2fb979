#include "striate/app/trial/trial_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "striate/app/trial/trial_plan.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/shell_text.hpp"
#include "striate/platform/simulator/random_world/random_world.hpp"

namespace striate::app {
namespace {

/// The paper, section on the corridor runs: 20 runs of each setup without collision.
struct PaperFigure {
  const char* setup;
  int successes;
};
/// Successes in 20 runs; paper, section on the corridor runs
constexpr PaperFigure kPaper[] = {{"corridor_a", 17}, {"corridor_b", 16}, {"corridor_c", 16}};

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

void add(Row& row, const agent::RunResult& result) {
  ++row.runs;
  row.touched += result.collisions.empty() ? 0 : 1;
  row.emergency_stops += result.emergency_stops;
  row.longest_stand_s = std::max(row.longest_stand_s, result.longest_stand_s);
  if (result.outcome != agent::RunOutcome::success) return;
  ++row.successes;
  row.time_s += result.duration_s;
  row.distance_m += result.distance_m;
  row.nearest_m = std::min(row.nearest_m, result.nearest_pass_m);
}

/// Of a drawn building its kind: a table of hundreds of buildings says something by kind alone.
std::string table_name(const agent::RunResult& result) {
  const auto drawn = simulator::drawn_from(world_name(result.world));
  if (!drawn) return row_name(result.world, result.baseline);
  const std::string& kind = simulator::building_kinds()[static_cast<std::size_t>(drawn->kind)];
  return row_name(kind + ", drawn", result.baseline);
}

std::string paper_of(const std::string& name) {
  for (const PaperFigure& figure : kPaper) {
    if (name == figure.setup) return fmt::format("{} / 20", figure.successes);
  }
  return "";
}

std::string line_of(const Row& row) {
  const Interval interval = wilson_interval(row.successes, row.runs);
  const std::string speed =
      row.time_s > 0.0 ? fmt::format("{:.2f} m/s", row.distance_m / row.time_s) : "";
  const std::string nearest =
      std::isfinite(row.nearest_m) ? fmt::format("{:.2f} m", row.nearest_m) : "";
  return fmt::format(
      "| {} | {} / {} | {:.0f} % | {:.0f} to {:.0f} % | {} | {} | {} | {} | {:.2f} | {:.0f} s |\n",
      row.name, row.successes, row.runs, 100.0 * row.successes / row.runs, 100.0 * interval.low,
      100.0 * interval.high, paper_of(row.name), row.touched, speed, nearest,
      static_cast<double>(row.emergency_stops) / row.runs, row.longest_stand_s);
}

std::string without_number(std::string name) {
  while (!name.empty() && (std::isdigit(static_cast<unsigned char>(name.back())) != 0 ||
                           name.back() == ' ' || name.back() == '_')) {
    name.pop_back();
  }
  return name;
}

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

/// What the world was to put into the way and did not: such a run shows nothing of how it is met.
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

}  // namespace

Interval wilson_interval(int successes, int runs) {
  if (runs <= 0) return {};
  // 97.5 % quantile of the normal distribution: an interval of 95 %
  constexpr double kZ = 1.959964;
  const double n = runs;
  const double p = successes / n;
  const double centre = (p + kZ * kZ / (2.0 * n)) / (1.0 + kZ * kZ / n);
  const double half =
      kZ / (1.0 + kZ * kZ / n) * std::sqrt(p * (1.0 - p) / n + kZ * kZ / (4.0 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

std::string runs_csv(const std::vector<agent::RunResult>& results) {
  std::string csv =
      "world,seed,outcome,reached_goal,collisions,first_hit,hit_moving,hit_light_level,hit_time_s,"
      "hit_along_m,hit_left_m,distance_m,duration_s,nearest_pass_m,emergency_stops,"
      "longest_stand_s,mean_cycle_ms,realtime_factor,emergency_layer,baseline,reason,"
      "longest_stand_why\n";
  for (const agent::RunResult& r : results) {
    csv += fmt::format("{},{},{},{},{},", csv_cell(world_name(r.world)), r.seed, name_of(r.outcome),
                       r.reached_goal, r.collisions.size());
    if (r.collisions.empty()) {
      csv += ",,,,,,";
    } else {
      const agent::CollisionRecord& hit = r.collisions.front();
      csv += fmt::format("{},{},{:.3f},{:.2f},{:.3f},{:.3f},", csv_cell(hit.hit), hit.moving,
                         hit.light_level, hit.time_s, hit.along_m, hit.left_m);
    }
    csv += fmt::format("{:.3f},{:.2f},{:.4f},{},{:.1f},{:.3f},{:.2f},{},{},{},{}\n", r.distance_m,
                       r.duration_s, r.nearest_pass_m, r.emergency_stops, r.longest_stand_s,
                       r.mean_cycle_ms, r.realtime_factor, r.emergency_layer, csv_cell(r.baseline),
                       csv_cell(r.reason), csv_cell(r.longest_stand_why));
  }
  return csv;
}

std::string trial_table(const std::vector<agent::RunResult>& results) {
  std::vector<Row> rows;
  std::map<std::string, Row> totals;  // of each baseline
  for (const agent::RunResult& result : results) {
    const std::string name = table_name(result);
    auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.name == name; });
    if (row == rows.end()) {
      rows.push_back({});
      row = rows.end() - 1;
      row->name = name;
    }
    add(*row, result);
    Row& total = totals[result.baseline];
    total.name = row_name("all", result.baseline);
    add(total, result);
  }
  std::string text =
      "| world | success | rate | 95 % interval | paper | touched | mean speed | nearest pass | "
      "emergency stops a run | longest stand |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Row& row : rows) text += line_of(row);
  for (const auto& [baseline, total] : totals) {
    if (rows.size() > totals.size()) text += line_of(total);
  }
  const std::string failures = causes(results);
  if (!failures.empty()) text += "\nWhat went wrong:\n" + failures;
  const std::string missed = never_put_down(results);
  if (!missed.empty()) text += "\nTo be put down during the run, and never was:\n" + missed;
  const std::string stands = long_stands(results);
  if (!stands.empty()) text += "\nStood for more than 30 s:\n" + stands;
  return text;
}

std::string replay_command(const agent::RunResult& result, const std::string& robot,
                           const std::string& memory, const std::vector<std::string>& plugins) {
  std::string with_plugins;
  for (const std::string& plugin : plugins) with_plugins += " --plugin " + shell_word(plugin);
  return fmt::format(
      "striate run {} --world {} --seed {}{}{}{}{}{} --picture-every 10 --pictures {}",
      shell_word(result.task), shell_word(result.world), result.seed,
      result.emergency_layer ? "" : " --no-emergency",
      result.baseline.empty() ? "" : " --baseline " + result.baseline,
      robot.empty() ? "" : " --robot " + shell_word(robot),
      memory.empty() ? "" : " --memory " + shell_word(memory), with_plugins,
      shell_word(fmt::format("out/replay/{}_seed{:03d}", world_name(result.world), result.seed)));
}

std::string replay_commands(const std::vector<agent::RunResult>& results, const std::string& robot,
                            const std::string& memory, const std::vector<std::string>& plugins) {
  std::string text;
  for (const agent::RunResult& result : results) {
    if (result.outcome == agent::RunOutcome::success) continue;
    text += "    " + replay_command(result, robot, memory, plugins) + "\n";
  }
  return text.empty() ? text : "\nTo see what failed again:\n" + text;
}

}  // namespace striate::app
