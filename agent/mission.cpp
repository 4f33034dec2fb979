#include "striate/agent/mission.hpp"

#include <chrono>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <utility>
#include <vector>

#include "striate/agent/given_variables.hpp"
#include "striate/platform/interface/plausible.hpp"

namespace striate::agent {
namespace {

/// Stands for ever: somebody else drives.
tasks::Task standing_task(const RobotDescription& robot) {
  config::Diagnostics diagnostics("the task to stand", 'T');
  tasks::Task task =
      tasks::read_task("striate: 1\nmission: stand\ndo:\n  - repeat:\n      - wait: {for: 60 s}\n",
                       diagnostics, robot);
  diagnostics.throw_if_any();
  return task;
}

/// Checks `needs: {landmarks: ...}` against what the memory knows; without one, nothing is known.
tasks::Task task_for(const MissionOptions& options, const tasks::GivenVariables& given,
                     const RobotDescription& robot) {
  if (options.task.empty()) return standing_task(robot);
  std::vector<std::string> names;
  if (options.knowledge) names = options.knowledge->names();
  tasks::Task task = tasks::load_task(options.task, robot, given, &names);
  check_variables(options.given, task);
  return task;
}

}  // namespace

MissionParts prepare(const MissionOptions& options, const BodySource& body) {
  MissionParts parts;
  parts.robot_file = options.robot;
  parts.settings = load_robot_settings(options.robot, &parts.notices, options.plugin_lines);
  if (!options.emergency_layer) parts.settings.safety.emergency_layer = false;
  parts.given = options.given;
  parts.given.insert(body.given.begin(), body.given.end());
  // Only the woken robot knows its limits; mistakes in the task are told before.
  (void)task_for(options, parts.given, body.description.value_or(simulated_robot(parts.settings)));
  parts.body = body.wake(parts.settings);
  if (const std::string why = why_implausible(parts.body.robot->description()); !why.empty()) {
    throw std::runtime_error("the robot cannot be such: " + why);
  }
  parts.task = task_for(options, parts.given, parts.body.robot->description());
  for (const auto& [name, value] : body.given) {
    // Whoever gives another course than the world's has another goal than its line.
    if (options.given.contains(name)) parts.task.goal = tasks::TaskGoal::steps;
  }
  parts.knowledge = options.knowledge;
  return parts;
}

Mission::Mission(MissionParts parts)
    : parts_(std::move(parts)),
      executive_(std::move(parts_.task)),
      watched_(*parts_.body.robot),
      cycle_(watched_, parts_.settings, executive_,
             {std::exchange(parts_.knowledge, std::nullopt), parts_.body.disparities}),
      began_(watched_.clock().now()),
      stand_(began_) {}

RunResult Mission::run(const EachCycle& each_cycle) {
  try {
    bool goes_on = true;
    while (goes_on && !abandoned_) {
      goes_on = step();
      const bool asked_to_end = each_cycle(*this);
      watch_the_judge();
      if (asked_to_end) interrupt("interrupted");
    }
  } catch (const std::exception& error) {
    lost_ = error.what();
  } catch (...) {
    lost_ = "an unknown error";
  }
  watched_.stop();
  return result();
}

bool Mission::step() {
  const auto begin = std::chrono::steady_clock::now();
  const bool goes_on = cycle_.step();
  wall_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Pose2& pose = cycle_.trace().senses.odometry.pose;
  if (++cycles_ > 1) driven_m_ += std::hypot(pose.x_m - last_pose_.x_m, pose.y_m - last_pose_.y_m);
  last_pose_ = pose;
  stand_.look(cycle_.trace());
  trajectory_.add(pose);
  return goes_on;
}

/// Ends the task from outside, so after everybody has seen the cycle as it was.
void Mission::watch_the_judge() {
  if (judge() == nullptr || !judge()->reached_goal()) return;
  if (executive_.task().goal != tasks::TaskGoal::line) return;
  executive_.interrupt(tasks::MissionState::succeeded, "beyond the goal line");
}

std::string Mission::hold() const {
  const std::string hold = parts_.body.hold ? parts_.body.hold() : std::string();
  return hold.empty() ? cycle_.trace().refused : hold;
}

bool Mission::waits_for_reset() const {
  return parts_.body.waits_for_reset && parts_.body.waits_for_reset();
}

void Mission::reset_body() const {
  if (parts_.body.reset) parts_.body.reset();
}

double Mission::mean_cycle_ms() const {
  if (cycles_ == 0) return 0.0;
  return 1000.0 * (wall_s_ - watched_.sense_s()) / static_cast<double>(cycles_);
}

double Mission::realtime_factor() const {
  if (judge() == nullptr) return 1.0;
  return wall_s_ > 0.0 ? to_seconds(watched_.clock().now() - began_) / wall_s_ : 0.0;
}

}  // namespace striate::agent
