#include "app/commands/run_on_robot.hpp"

#include <fmt/format.h>

#include "app/interrupt.hpp"
#include "app/mission_memory.hpp"
#include "app/recall/live_memory.hpp"
#include "app/recording/mission_recorder.hpp"
#include "app/status_line.hpp"
#include "base/files.hpp"
#include "base/user_error.hpp"

namespace striate {
namespace {

GivenVariables variables(const std::vector<std::string>& given) {
  GivenVariables variables;
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw UserError("--var '" + text + "': is no variable\n  hint: --var \"way=20 m\"");
    }
    variables[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return variables;
}

std::string status_text(const RobotMission& mission) {
  const CycleTrace& trace = mission.cycle().trace();
  std::string doing(trace.wish.why.view());
  if (trace.limited_by != LimitReason::none && trace.limited_by != LimitReason::acceleration) {
    doing += fmt::format(" [limited: {}]", name_of(trace.limited_by));
  }
  if (const std::string hold = mission.hold(); !hold.empty()) {
    doing += fmt::format(" [gate: {}]", hold);
  }
  return fmt::format("{:5.1f} s  {:5.1f} m  {:.2f} m/s  {:.1f} V  {:.1f} ms a cycle  {}: {}",
                     to_seconds(trace.senses.now), mission.cycle().memory().progress_m(),
                     trace.senses.odometry.forward_m_s, trace.senses.battery_v,
                     mission.mean_cycle_ms(), mission.executive().current_action(), doing);
}

void print_summary(const RunResult& result) {
  fmt::print("{} with the robot at {}: {}{}\n", result.task, result.world, result.outcome,
             result.reason.empty() ? "" : " (" + result.reason + ")");
  fmt::print("  driven            {:.1f} m in {:.0f} s ({:.2f} m/s), by odometry\n",
             result.distance_m, result.duration_s,
             result.distance_m / std::max(result.duration_s, 0.1));
  fmt::print("  emergency stops   {}{}\n", result.emergency_stops,
             result.emergency_layer ? "" : " (sonar and laser are off)");
  fmt::print("  longest stand     {:.0f} s{}\n", result.longest_stand_s, stood_for(result));
  fmt::print("  thinking          {:.1f} ms a cycle\n", result.mean_cycle_ms);
}

/// What only a judge beside the robot could know is left out.
std::string json_of(const RunResult& result) {
  nlohmann::ordered_json json = to_json(result);
  for (const char* key : {"nearest_pass_m", "collisions", "seed"}) json.erase(key);
  return json.dump(2) + "\n";
}

}  // namespace

int run_on_robot(const RunOnRobotOptions& options) {
  RobotMissionOptions asked = options.mission;
  asked.given = variables(options.given);
  if (!options.result.empty()) check_writable(options.result);
  if (!options.memory.empty()) asked.knowledge = read_mission_knowledge(options.memory);
  const Interrupt interrupt;
  MissionRecorder recorder(options.record, options.memory);
  RobotMission mission(asked);
  MissionMemory memory(options.memory, asked.robot,
                       fmt::format("{} with {}", asked.task, asked.robot));
  recorder.begin(mission);
  LiveMemory live(options.inspect);
  if (options.at_begin) options.at_begin(mission);
  StatusLine status(options.quiet || options.json);
  const RunResult result = mission.run([&](const RobotMission&) {
    recorder.take(mission.cycle(), mission.executive());
    live.take(mission.cycle(), mission.executive(), mission.cycles());
    memory.take(mission.cycle());
    if (options.each_cycle) options.each_cycle(mission);
    if (status.due()) status.show(status_text(mission));
    return Interrupt::requested();
  });
  status.clear();
  const std::string recorded = recorder.finish();
  live.finish();
  memory.finish(mission.cycle(), result);
  if (!options.result.empty()) write_file(options.result, json_of(result));
  if (options.json) {
    fmt::print("{}", json_of(result));
  } else if (!options.quiet) {
    print_summary(result);
    if (!recorded.empty()) fmt::print("  recording         {}\n", recorded);
  }
  return exit_code_of(result);
}

}  // namespace striate
