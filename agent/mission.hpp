#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "striate/agent/body.hpp"
#include "striate/agent/cognitive_cycle.hpp"
#include "striate/agent/drawn_trajectory.hpp"
#include "striate/agent/longest_stand.hpp"
#include "striate/agent/run_result.hpp"
#include "striate/agent/stopwatch_robot.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::agent {

/// What a mission is asked for, whatever its body.
struct MissionOptions {
  std::string task;             ///< empty: to stand, for whoever else drives
  std::string robot;            ///< settings file; empty: the built-in defaults
  tasks::GivenVariables given;  ///< beside those that the body's place gives
  /// What the long-term memory knows; none: there is no memory.
  std::optional<MissionKnowledge> knowledge;
  bool emergency_layer = true;
  PluginLines plugin_lines = PluginLines::load;  ///< of the settings file
};

/// What a mission is made of.
struct MissionParts {
  RobotSettings settings;
  Body body;
  tasks::Task task;
  std::optional<MissionKnowledge> knowledge;
  std::string robot_file;       ///< that the settings are from; "" for none
  tasks::GivenVariables given;  ///< all that the task was given
  std::string notices;          ///< of the settings
};

/// Reads and checks everything, then wakes the body. Nothing has moved.
/// @throws UserError with all mistakes of the task or the settings, and as the body does
[[nodiscard]] MissionParts prepare(const MissionOptions& options, const BodySource& body);

/// One run of a task by a robot: simulated, real, behind ROS or recorded. A judge watches where the
/// body has one; else it is the task that says how it went.
class Mission {
 public:
  explicit Mission(MissionParts parts);
  Mission(const MissionOptions& options, const BodySource& body)
      : Mission(prepare(options, body)) {}
  Mission(const Mission&) = delete;
  Mission& operator=(const Mission&) = delete;

  /// Called after each cycle; returns true to ask for a safe end (Ctrl-C).
  using EachCycle = std::function<bool(const Mission&)>;

  /// Drives to the end, whatever that is; never throws for what happens on the way.
  RunResult run(const EachCycle& each_cycle);
  /// One cycle of it, for whoever steers the run; false at its end. May throw as the body does.
  bool step();
  /// Asks for a safe end: halts the actions, then `finally`.
  void interrupt(const std::string& why) {
    executive_.interrupt(tasks::MissionState::interrupted, why);
  }
  /// Ends run() after this cycle as an interrupted one, also where `finally` is not done.
  void abandon() {
    interrupt("interrupted");
    abandoned_ = true;
  }

  void set_pilot(CognitiveCycle::Pilot pilot) { cycle_.set_pilot(std::move(pilot)); }
  [[nodiscard]] const CognitiveCycle& cycle() const { return cycle_; }
  [[nodiscard]] CognitiveCycle& cycle() { return cycle_; }
  [[nodiscard]] const tasks::Executive& executive() const { return executive_; }
  [[nodiscard]] const RobotSettings& settings() const { return parts_.settings; }
  /// What was read but should be written otherwise, for the caller to show; "" for nothing.
  [[nodiscard]] std::string notices() const { return parts_.notices + executive_.task().notices; }
  [[nodiscard]] const std::string& robot_file() const { return parts_.robot_file; }
  [[nodiscard]] const tasks::GivenVariables& given() const { return parts_.given; }
  [[nodiscard]] const Robot& body() const { return *parts_.body.robot; }
  [[nodiscard]] const std::string& place() const { return parts_.body.place; }
  /// Why the body's own gate holds the robot, or slows it, or why its image was refused; "": no.
  [[nodiscard]] std::string hold() const;
  /// Whether that lasts until `reset_body`.
  [[nodiscard]] bool waits_for_reset() const;
  /// Somebody has looked at the robot and lets it go on: ends what its gate has latched.
  void reset_body() const;
  /// nullptr: nobody judges.
  [[nodiscard]] const simulator::Judge* judge() const { return parts_.body.judge; }
  /// nullptr: nobody judges, or the body is no simulated one.
  [[nodiscard]] const SimulatedBody* simulated() const { return parts_.body.simulated; }
  /// Where the robot believes it has been (odometry frame), oldest first.
  [[nodiscard]] const std::deque<Point2>& trajectory() const { return trajectory_.points(); }
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }
  [[nodiscard]] double mean_cycle_ms() const;
  /// Robot time over wall-clock time. @return 1 for a body that lives in real time
  [[nodiscard]] double realtime_factor() const;

 private:
  void watch_the_judge();
  [[nodiscard]] RunResult result() const;
  [[nodiscard]] RunOutcome outcome() const;
  [[nodiscard]] bool succeeded() const;
  [[nodiscard]] std::string reason_of(RunOutcome outcome) const;
  void tell_what_the_judge_knows(RunResult& result) const;

  MissionParts parts_;
  tasks::Executive executive_;
  StopwatchRobot watched_;
  CognitiveCycle cycle_;
  TimePoint began_;
  LongestStand stand_;
  DrawnTrajectory trajectory_;
  std::uint64_t cycles_ = 0;
  double wall_s_ = 0.0;
  double driven_m_ = 0.0;  ///< by odometry
  Pose2 last_pose_;
  bool abandoned_ = false;
  std::string lost_;  ///< why the body was lost; empty: it was not
};

}  // namespace striate::agent
