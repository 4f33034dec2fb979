#include "striate/app/trial/trial_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "striate/app/trial/trial_notes.hpp"
#include "striate/app/trial/trial_plan.hpp"
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

}  // namespace striate::app
