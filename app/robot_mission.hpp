#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/cognitive_cycle.hpp"
#include "app/longest_stand.hpp"
#include "app/memory/landmark_knowledge.hpp"
#include "app/run_result.hpp"
#include "app/stopwatch_robot.hpp"
#include "tasks/task_reader.hpp"

namespace striate {

/// A body that no judge watches, and what is known about it.
struct RealBody {
  std::unique_ptr<Robot> robot;
  std::string place;  ///< where it is: an address, a world, "ROS"
  /// Why the body's own gate holds it or slows it; "": it does not. May be empty.
  std::function<std::string()> hold;
};
/// The Pioneer whose devices the settings name. @throws UserError where they do not.
RealBody connect_pioneer(const RobotSettings& settings);

/// What `striate run` without a world is asked for.
struct RobotMissionOptions {
  std::string task;   ///< empty: to stand, for whoever else drives
  std::string robot;  ///< settings file that says where the devices are
  GivenVariables given;
  /// What the long-term memory knows; none: there is no memory.
  std::optional<MissionKnowledge> knowledge;
  bool emergency_layer = true;
  std::function<RealBody(const RobotSettings&)> body = connect_pioneer;
};

/// One run of a task with a real robot, or one that is served like a real one. Nobody judges it but
/// the task itself.
class RobotMission {
 public:
  /// Reads and checks everything, then connects. @throws UserError with all mistakes of the task or
  /// the settings, std::runtime_error when the robot does not come up.
  explicit RobotMission(const RobotMissionOptions& options);

  /// Called after each cycle; returns true to ask for a safe end (Ctrl-C).
  using EachCycle = std::function<bool(const RobotMission&)>;

  /// Drives to the end, whatever that is; never throws for what happens on the way.
  RunResult run(const EachCycle& each_cycle);

  [[nodiscard]] const CognitiveCycle& cycle() const { return *cycle_; }
  [[nodiscard]] const Robot& body() const { return *body_.robot; }
  [[nodiscard]] const RobotSettings& settings() const { return settings_; }
  void set_pilot(CognitiveCycle::Pilot pilot) { cycle_->set_pilot(std::move(pilot)); }
  /// Why the body's own gate holds the robot, or slows it; "": it does not.
  [[nodiscard]] std::string hold() const { return body_.hold ? body_.hold() : std::string(); }
  [[nodiscard]] CognitiveCycle& cycle() { return *cycle_; }
  [[nodiscard]] const Executive& executive() const { return executive_; }
  [[nodiscard]] const RobotMissionOptions& options() const { return options_; }
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }
  [[nodiscard]] double mean_cycle_ms() const;

 private:
  void one_cycle_on();
  [[nodiscard]] RunResult result() const;

  RobotMissionOptions options_;
  RobotSettings settings_;
  RealBody body_;
  Executive executive_;
  std::unique_ptr<StopwatchRobot> watched_;
  std::unique_ptr<CognitiveCycle> cycle_;
  std::uint64_t cycles_ = 0;
  double wall_s_ = 0.0;
  double driven_m_ = 0.0;
  Pose2 last_pose_;
  TimePoint began_;
  LongestStand stand_;
  std::string lost_;  ///< why the robot was lost; empty: it was not
};

}  // namespace striate
