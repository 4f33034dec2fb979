#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "striate/agent/run_outcome.hpp"

namespace striate::agent {

/// One touch, as the judge saw it.
struct CollisionRecord {
  double time_s = 0.0;
  double along_m = 0.0;  ///< corridor coordinates of the robot
  double left_m = 0.0;
  std::string hit;           ///< what was touched: "table 1", "wall left", "person 2"
  double light_level = 0.0;  ///< 0 dark .. 1 as bright as an office
  bool moving = false;       ///< what was hit moved by itself
};

/// An obstacle that the world was to put down during the run.
struct LateObstacleRecord {
  std::string name;
  std::optional<double> time_s;  ///< when it was put down; none: never, so nobody met it
  double driven_m = 0.0;         ///< by the robot until then
};

/// What came of one run; `--result` writes it. Only the figures named wall-clock differ between
/// two runs of the same seed in a world.
struct RunResult {
  RunOutcome outcome = RunOutcome::task_ended;
  std::string reason;  ///< in words; empty for a success
  /// What failed of the task: a name of behaviours::all_failures() and the line of its script;
  /// empty and 0 unless the outcome is task_failed.
  std::string failure;
  int failure_line = 0;
  /// A judge watched. Without one there are no collisions, nearest pass and seed, also not in JSON;
  /// the goal is reached where the task has succeeded, and the way is that of the odometry.
  bool judged = true;
  bool reached_goal = false;
  std::vector<CollisionRecord> collisions;
  std::vector<LateObstacleRecord> late_obstacles;  ///< of a simulated run; in the world's order
  double distance_m = 0.0;                         ///< driven
  double duration_s = 0.0;                         ///< on the robot's clock
  double nearest_pass_m = 0.0;    ///< smallest distance of the robot's outline to anything
  int emergency_stops = 0;        ///< how often sonar, laser or bumper stepped in
  double longest_stand_s = 0.0;   ///< longest time without moving
  std::string longest_stand_why;  ///< what the robot said at its end
  /// Truly, at the end, from where the run began; only for a task whose goal is not the world's
  /// line.
  std::optional<double> from_start_m;
  std::uint64_t cycles = 0;
  double mean_cycle_ms = 0.0;    ///< wall-clock: seeing, remembering, wanting, moving
  double realtime_factor = 0.0;  ///< wall-clock: simulated over real time
  std::uint64_t seed = 0;
  std::string world;
  std::string task;
  bool emergency_layer = true;
  /// Whose disparities it drove by: paper, sgbm, truth; empty: Striate's own.
  std::string baseline;
};

[[nodiscard]] nlohmann::ordered_json to_json(const RunResult& result);
/// @throws std::runtime_error where the JSON is no result of a run that a judge watched.
[[nodiscard]] RunResult run_result_from_json(const nlohmann::json& json);

/// " (why)" of the longest stand; empty where nothing is to be said.
[[nodiscard]] std::string stood_for(const RunResult& result);

/// "new_box after 41 s, new_chair never".
[[nodiscard]] std::string late_obstacles_text(const RunResult& result);

/// "collision (touched table 1)", "success".
[[nodiscard]] std::string outcome_text(const RunResult& result);

}  // namespace striate::agent
