#include <algorithm>
#include <cmath>

#include "striate/agent/mission.hpp"
#include "striate/agent/simulated_body.hpp"

/// How a mission came out: what the task, the judge and the robot's own senses say of it.
namespace striate::agent {

/// A task that is after the goal line is judged by whether that was crossed; any other, and where
/// nobody sees the line, by whether it succeeds.
bool Mission::succeeded() const {
  const bool by_steps = executive_.state() == tasks::MissionState::succeeded;
  if (judge() == nullptr) return by_steps;
  if (executive_.task().goal == tasks::TaskGoal::line) return judge()->reached_goal();
  return by_steps && executive_.ended();
}

RunOutcome Mission::outcome() const {
  if (!lost_.empty()) return RunOutcome::lost;
  const bool ended = executive_.state() != tasks::MissionState::running;
  if (abandoned_ && !ended) return RunOutcome::interrupted;
  if (executive_.state() == tasks::MissionState::interrupted) return RunOutcome::interrupted;
  if (judge() != nullptr && !judge()->collisions().empty()) return RunOutcome::collision;
  if (succeeded()) return RunOutcome::success;
  if (judge() != nullptr && judge()->outcome() == simulator::Verdict::time_up) {
    return RunOutcome::time_over;
  }
  if (!executive_.ended()) return RunOutcome::body_ended;
  return executive_.state() == tasks::MissionState::failed ? RunOutcome::task_failed
                                                           : RunOutcome::task_ended;
}

std::string Mission::reason_of(RunOutcome outcome) const {
  switch (outcome) {
    case RunOutcome::success:
      return {};
    case RunOutcome::lost:
      return lost_;
    case RunOutcome::collision:
      return "touched " + judge()->collisions().front().hit;
    case RunOutcome::time_over:
      return "the judge's time limit has passed";
    case RunOutcome::body_ended:
      return "the recording or the robot has ended";
    case RunOutcome::task_ended:
      return "the task ended before the goal line";
    case RunOutcome::task_failed:
    case RunOutcome::interrupted:
      break;
  }
  return executive_.reason();
}

namespace {

std::vector<LateObstacleRecord> late_obstacles_of(const SimulatedBody& body) {
  std::vector<LateObstacleRecord> records;
  const auto& put_down = body.late_obstacles().put_down();
  for (std::size_t i = 0; i < body.world().obstacles.size(); ++i) {
    const simulator::WorldObstacle& obstacle = body.world().obstacles[i];
    if (!comes_late(obstacle)) continue;
    LateObstacleRecord& record = records.emplace_back();
    record.name = obstacle.name;
    for (const auto& one : put_down) {
      if (one.obstacle != i) continue;
      record.time_s = one.time_s;
      record.driven_m = one.driven_m;
    }
  }
  return records;
}

}  // namespace

RunResult Mission::result() const {
  RunResult result;
  result.outcome = outcome();
  result.reason = reason_of(result.outcome);
  if (result.outcome == RunOutcome::task_failed) {
    result.failure = name_of(executive_.newest_failure().failure());
    result.failure_line = executive_.newest_failure().line();
  }
  result.judged = judge() != nullptr;
  result.reached_goal = result.outcome == RunOutcome::success;
  result.distance_m = driven_m_;
  result.duration_s = to_seconds(watched_.clock().now() - began_);
  result.emergency_stops = cycle_.limiter().emergency_stops();
  result.longest_stand_s = stand_.time_s();
  result.longest_stand_why = stand_.why();
  result.cycles = cycles_;
  result.mean_cycle_ms = mean_cycle_ms();
  result.realtime_factor = realtime_factor();
  result.world = place();
  result.task = executive_.task().file;
  result.emergency_layer = settings().safety.emergency_layer;
  if (judge() != nullptr) tell_what_the_judge_knows(result);
  return result;
}

void Mission::tell_what_the_judge_knows(RunResult& result) const {
  for (const simulator::Collision& hit : judge()->collisions()) {
    result.collisions.push_back(
        {hit.time_s, hit.along_m, hit.left_m, hit.hit, hit.light_level, hit.moving});
  }
  result.reached_goal = judge()->reached_goal();
  result.distance_m = judge()->distance_driven_m();
  result.nearest_pass_m = std::min(judge()->nearest_pass_m(), 100.0);
  if (executive_.task().goal != tasks::TaskGoal::line && !judge()->path().empty()) {
    const Pose2& start = judge()->path().front().pose;
    const Pose2& end = judge()->now().pose;
    result.from_start_m = std::hypot(end.x_m - start.x_m, end.y_m - start.y_m);
  }
  if (simulated() == nullptr) return;
  result.seed = simulated()->options().seed;
  result.baseline = simulated()->options().baseline;
  result.late_obstacles = late_obstacles_of(*simulated());
}

}  // namespace striate::agent
