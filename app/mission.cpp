#include "app/mission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "app/baselines/baseline.hpp"
#include "platform/simulator/world_reader.hpp"
#include "tasks/task_reader.hpp"

namespace striate {
namespace {

RobotSettings settings_for(const MissionOptions& options) {
  RobotSettings settings = load_robot_settings(options.robot);
  if (!options.emergency_layer) settings.safety.emergency_layer = false;
  // The goal line ends the task, not the body: `finally` is still to be run.
  settings.simulator.judge.ends_at_goal = false;
  apply_baseline(baseline_named(options.baseline), settings.perception);
  return settings;
}

simulator::World world_for(const MissionOptions& options) {
  simulator::World world = simulator::load_world(options.world);
  if (options.start) world.start = *options.start;
  return world;
}

/// How far to drive is for the person to say: `way` leads to the goal line and a little beyond,
/// `there` ends a little before it, because the robot's own count of its way is not exact.
GivenVariables course_of(const simulator::World& world) {
  // m: 2.5 % of the 60 m corridor, three times the odometry's error of 0.75 %
  constexpr double kMargin_m = 1.5;
  const double line_m = world.goal_beyond_m - world.start.x_m;
  return {{"way", config::print_quantity(line_m + kMargin_m, config::Unit::length)},
          {"there", config::print_quantity(line_m - kMargin_m, config::Unit::length)}};
}

/// A task that asks for the way to the goal line has it as its goal; any other is judged by
/// whether it succeeds.
bool goal_is_the_line(const Task& task) {
  return std::find(task.variables.begin(), task.variables.end(), "way") != task.variables.end();
}

/// Only the baseline `truth` has pictures that know their depth.
std::unique_ptr<TrueDepthPictures> with_depth(Baseline baseline, RendererPictures& pictures,
                                              const RobotSettings& settings) {
  if (baseline != Baseline::truth) return nullptr;
  return std::make_unique<TrueDepthPictures>(pictures, pictures.renderer(),
                                             settings.perception.stereo.width);
}

/// Checks `needs: {landmarks: ...}` against what the memory knows.
Task task_for(const MissionOptions& options, const simulator::World& world) {
  std::vector<std::string> names;
  if (options.knowledge) names = options.knowledge->names();
  return load_task(options.task, RobotDescription{}, course_of(world),
                   options.knowledge ? &names : nullptr);
}

}  // namespace

Mission::Mission(const MissionOptions& options)
    : options_(options),
      settings_(settings_for(options)),
      world_(world_for(options)),
      plan_(simulator::build_floor_plan(world_)),
      executive_(task_for(options, world_)),
      pictures_(std::make_unique<RendererPictures>(world_, plan_, settings_.camera, options.seed)),
      true_pictures_(with_depth(baseline_named(options.baseline), *pictures_, settings_)),
      disparities_(disparities_of(baseline_named(options.baseline), settings_.perception,
                                  true_pictures_.get())),
      body_(std::make_unique<simulator::SimulatedPioneer>(
          world_, options.seed, settings_.simulator,
          true_pictures_ ? static_cast<simulator::PictureSource*>(true_pictures_.get())
                         : pictures_.get())),
      watched_(std::make_unique<StopwatchRobot>(*body_)),
      cycle_(std::make_unique<CognitiveCycle>(*watched_, settings_, executive_)),
      stand_(body_->clock().now()) {
  if (disparities_) cycle_->see_with(*disparities_);
  if (!options_.knowledge) return;
  hand_over(std::move(*options_.knowledge), executive_.task(), settings_.long_term_memory, *cycle_);
  options_.knowledge.reset();
}

RunResult Mission::run(const EachCycle& each_cycle) {
  try {
    while (true) {
      const auto begin = std::chrono::steady_clock::now();
      const bool goes_on = cycle_->step();
      wall_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      ++cycles_;
      one_cycle_on();
      const bool asked_to_end = each_cycle(*this);
      watch_the_judge();
      if (asked_to_end) executive_.interrupt(MissionState::interrupted, "interrupted");
      if (!goes_on) break;
    }
  } catch (const std::exception& error) {
    lost_ = error.what();
  }
  watched_->stop();
  return result();
}

void Mission::one_cycle_on() {
  stand_.look(cycle_->trace());
  trail_.add(cycle_->trace().senses.odometry.pose);
}

/// Ends the task from outside, so after everybody has seen the cycle as it was.
void Mission::watch_the_judge() {
  if (body_->judge().reached_goal() && goal_is_the_line(executive_.task())) {
    executive_.interrupt(MissionState::succeeded, "beyond the goal line");
  }
}

GivenVariables Mission::given() const {
  return course_of(world_);
}

double Mission::mean_cycle_ms() const {
  if (cycles_ == 0) return 0.0;
  return 1000.0 * (wall_s_ - watched_->sense_s()) / static_cast<double>(cycles_);
}

double Mission::realtime_factor() const {
  return wall_s_ > 0.0 ? to_seconds(body_->clock().now()) / wall_s_ : 0.0;
}

RunResult Mission::result() const {
  const simulator::Judge& judge = body_->judge();
  RunResult result;
  for (const simulator::Collision& hit : judge.collisions()) {
    result.collisions.push_back(
        {hit.time_s, hit.along_m, hit.left_m, hit.hit, hit.light_level, hit.moving});
  }
  result.reached_goal = judge.reached_goal();
  result.reason = executive_.reason();
  if (!lost_.empty()) {
    result.outcome = "lost";
    result.reason = lost_;
  } else if (executive_.state() == MissionState::interrupted) {
    result.outcome = "interrupted";
  } else if (!result.collisions.empty()) {
    result.outcome = "collision";
    result.reason = "touched " + result.collisions.front().hit;
  } else if (goal_is_the_line(executive_.task())
                 ? result.reached_goal
                 : executive_.ended() && executive_.state() == MissionState::succeeded) {
    result.outcome = "success";
    result.reason.clear();
  } else if (judge.outcome() == simulator::Outcome::time_up) {
    result.outcome = "time_over";
    result.reason = "the judge's time limit has passed";
  } else if (executive_.state() == MissionState::failed) {
    result.outcome = "task_failed";
  } else {
    result.outcome = "task_ended";
    result.reason = "the task ended before the goal line";
  }
  result.distance_m = judge.distance_driven_m();
  result.duration_s = to_seconds(body_->clock().now());
  result.nearest_pass_m = std::min(judge.nearest_pass_m(), 100.0);
  if (!goal_is_the_line(executive_.task()) && !judge.path().empty()) {
    const Pose2& start = judge.path().front().pose;
    const Pose2& end = judge.now().pose;
    result.from_start_m = std::hypot(end.x_m - start.x_m, end.y_m - start.y_m);
  }
  result.emergency_stops = cycle_->limiter().emergency_stops();
  result.longest_stand_s = stand_.time_s();
  result.longest_stand_why = stand_.why();
  result.cycles = cycles_;
  result.mean_cycle_ms = mean_cycle_ms();
  result.realtime_factor = realtime_factor();
  result.seed = options_.seed;
  result.world = options_.world;
  result.task = options_.task;
  result.baseline = options_.baseline;
  result.emergency_layer = settings_.safety.emergency_layer;
  return result;
}

}  // namespace striate
