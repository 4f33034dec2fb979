#include "striate/app/commands/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace striate::app {
namespace {

std::string collisions_text(const agent::RunResult& result) {
  std::string text = fmt::format("  collisions        {}\n", result.collisions.size());
  for (const agent::CollisionRecord& hit : result.collisions) {
    text += fmt::format("    {:.1f} s: {} ({}) at {:.1f} m, {:+.2f} m, light {:.2f}\n", hit.time_s,
                        hit.hit, hit.moving ? "moving" : "still", hit.along_m, hit.left_m,
                        hit.light_level);
  }
  return text;
}

}  // namespace

std::string fitting(const std::vector<StatusPart>& parts, std::size_t columns) {
  std::vector<StatusPart> kept = parts;
  const auto length = [&] {
    std::size_t sum = 0;
    for (const StatusPart& part : kept) sum += part.text.size();
    return sum;
  };
  while (length() > columns) {
    const auto least = std::ranges::max_element(kept, {}, &StatusPart::drops);
    if (least->drops == 0) break;
    kept.erase(least);
  }
  std::string text;
  for (const StatusPart& part : kept) text += part.text;
  return text;
}

std::string status_text(const agent::Mission& mission, std::size_t columns) {
  const agent::CognitiveCycle& cycle = mission.cycle();
  const agent::CycleTrace& trace = cycle.trace();
  const bool real_time = mission.judge() == nullptr;
  std::vector<StatusPart> parts = {
      {2, fmt::format("{:5.1f} s  ", to_seconds(trace.senses.now))},
      {1, fmt::format("{:5.1f} m  ", cycle.memory().progress_m())},
      {3, fmt::format("{:.2f} m/s  ", trace.senses.odometry.forward_m_s)}};
  if (real_time) parts.push_back({4, fmt::format("{:.1f} V  ", trace.senses.battery_v)});
  parts.push_back({5, fmt::format("{:.1f} ms a cycle  ", mission.mean_cycle_ms())});
  if (!real_time) {
    parts.push_back({6, fmt::format("{:4.1f} x real time  ", mission.realtime_factor())});
  }
  if (const std::string hold = mission.hold(); !hold.empty()) {
    parts.push_back({0, fmt::format("[gate: {}] ", hold)});
  }
  parts.push_back({0, fmt::format("{}: {}", mission.executive().current_action(),
                                  agent::doing_text(trace.wish.why, trace.limited_by))});
  return fitting(parts, columns);
}

std::string Speech::news(const agent::Mission& mission) {
  if (mission.executive().current_action() != "say") {
    said_.clear();
    return {};
  }
  const std::string_view words = mission.cycle().trace().wish.why.view();
  if (words == said_) return {};
  said_ = words;
  return said_;
}

std::string summary_text(const agent::RunResult& result) {
  const std::string where = result.judged ? fmt::format("in {}, seed {}", result.world, result.seed)
                                          : "with the robot at " + result.world;
  std::string text = fmt::format("{} {}: {}\n", result.task, where, agent::outcome_text(result));
  if (result.judged)
    text += fmt::format("  goal reached      {}\n", result.reached_goal ? "yes" : "no");
  text +=
      fmt::format("  driven            {:.1f} m in {:.0f} s ({:.2f} m/s){}\n", result.distance_m,
                  result.duration_s, result.distance_m / std::max(result.duration_s, 0.1),
                  result.judged ? "" : ", by odometry");
  if (result.judged) text += fmt::format("  nearest pass      {:.2f} m\n", result.nearest_pass_m);
  text += fmt::format("  emergency stops   {}{}\n", result.emergency_stops,
                      result.emergency_layer ? "" : " (sonar and laser are off)");
  if (result.from_start_m) {
    text += fmt::format("  ends              {:.2f} m from the start\n", *result.from_start_m);
  }
  if (!result.late_obstacles.empty()) {
    text += fmt::format("  put down          {}\n", agent::late_obstacles_text(result));
  }
  text += fmt::format("  longest stand     {:.0f} s{}\n", result.longest_stand_s,
                      agent::stood_for(result));
  if (result.judged) text += collisions_text(result);
  text += fmt::format("  thinking          {:.1f} ms a cycle{}\n", result.mean_cycle_ms,
                      result.judged
                          ? fmt::format(", {:.1f} times real time in all", result.realtime_factor)
                          : std::string());
  return text;
}

}  // namespace striate::app
