#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/baselines/true_depth_pictures.hpp"
#include "app/cognitive_cycle.hpp"
#include "app/drawn_trail.hpp"
#include "app/longest_stand.hpp"
#include "app/memory/landmark_knowledge.hpp"
#include "app/run_result.hpp"
#include "app/stopwatch_robot.hpp"
#include "platform/simulator/simulated_pioneer.hpp"
#include "tasks/task_reader.hpp"

namespace striate {

/// What `striate run` is asked for.
struct MissionOptions {
  std::string task;
  std::string world;
  std::string robot;       ///< settings file; empty: the built-in defaults
  std::uint64_t seed = 1;  ///< any; the first run of a series
  bool emergency_layer = true;
  std::string baseline;  ///< whose disparities: paper, sgbm, truth; empty: Striate's own
  /// Along the corridor, left of its middle, heading; none: the world's own start.
  std::optional<Pose2> start;
  /// What the long-term memory knows; none: there is no memory.
  std::optional<MissionKnowledge> knowledge;
};

/// One run of a task in a simulated world: the body, the mind, and the judge that watches.
class Mission {
 public:
  /// Reads and checks everything before anything moves.
  /// @throws UserError with all mistakes of the task, the world or the settings.
  explicit Mission(const MissionOptions& options);

  /// Called after each cycle; returns true to ask for a safe end (Ctrl-C).
  using EachCycle = std::function<bool(const Mission&)>;

  /// Drives to the end, whatever that is; never throws for what happens on the way.
  RunResult run(const EachCycle& each_cycle);

  [[nodiscard]] const CognitiveCycle& cycle() const { return *cycle_; }
  [[nodiscard]] CognitiveCycle& cycle() { return *cycle_; }
  [[nodiscard]] const Executive& executive() const { return executive_; }
  [[nodiscard]] const simulator::SimulatedPioneer& body() const { return *body_; }
  [[nodiscard]] const simulator::World& world() const { return world_; }
  [[nodiscard]] const simulator::FloorPlan& plan() const { return plan_; }
  [[nodiscard]] const simulator::PictureSource& light() const { return *pictures_; }
  /// Where the robot believes it has been (odometry frame), oldest first.
  [[nodiscard]] const std::deque<Point2>& trail() const { return trail_.points(); }
  [[nodiscard]] const MissionOptions& options() const { return options_; }
  [[nodiscard]] const RobotSettings& settings() const { return settings_; }
  /// What the task was given from outside: how far it is.
  [[nodiscard]] GivenVariables given() const;
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }
  [[nodiscard]] double mean_cycle_ms() const;
  [[nodiscard]] double realtime_factor() const;

 private:
  void one_cycle_on();
  void watch_the_judge();
  [[nodiscard]] RunResult result() const;

  MissionOptions options_;
  RobotSettings settings_;
  simulator::World world_;
  simulator::FloorPlan plan_;
  Executive executive_;
  std::unique_ptr<RendererPictures> pictures_;
  std::unique_ptr<TrueDepthPictures> true_pictures_;  ///< of the baseline `truth`, else null
  std::unique_ptr<DisparitySource> disparities_;      ///< of a baseline, else null
  std::unique_ptr<simulator::SimulatedPioneer> body_;
  std::unique_ptr<StopwatchRobot> watched_;
  std::unique_ptr<CognitiveCycle> cycle_;
  DrawnTrail trail_;
  LongestStand stand_;
  std::uint64_t cycles_ = 0;
  double wall_s_ = 0.0;
  std::string lost_;  ///< why the body was lost; empty: it was not
};

}  // namespace striate
