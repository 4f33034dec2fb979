#include <fmt/format.h>

#include "striate/app/trial/trial_plan.hpp"
#include "striate/app/trial/trial_table.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/shell_text.hpp"
#include "striate/platform/simulator/random_world/random_world.hpp"

namespace striate::app {

std::string runs_csv(const std::vector<agent::RunResult>& results) {
  std::string csv =
      "world,seed,outcome,reached_goal,collisions,first_hit,hit_moving,hit_light_level,hit_time_s,"
      "hit_along_m,hit_left_m,distance_m,duration_s,nearest_pass_m,emergency_stops,"
      "longest_stand_s,mean_cycle_ms,realtime_factor,emergency_layer,baseline,reason,"
      "longest_stand_why,failure,failure_line\n";
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
    csv +=
        fmt::format("{:.3f},{:.2f},{:.4f},{},{:.1f},{:.3f},{:.2f},{},{},{},{},{},{}\n",
                    r.distance_m, r.duration_s, r.nearest_pass_m, r.emergency_stops,
                    r.longest_stand_s, r.mean_cycle_ms, r.realtime_factor, r.emergency_layer,
                    csv_cell(r.baseline), csv_cell(r.reason), csv_cell(r.longest_stand_why),
                    csv_cell(r.failure), r.failure.empty() ? "" : std::to_string(r.failure_line));
  }
  return csv;
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
