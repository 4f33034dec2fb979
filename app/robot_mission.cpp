#include "app/robot_mission.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>
#include <vector>

#include "base/user_error.hpp"
#include "platform/pioneer/pioneer_robot.hpp"

namespace striate {
namespace {

RobotSettings settings_for(const RobotMissionOptions& options) {
  RobotSettings settings = load_robot_settings(options.robot);
  if (!options.emergency_layer) settings.safety.emergency_layer = false;
  return settings;
}

/// Stands for ever: somebody else drives.
Task standing_task(const RobotDescription& robot) {
  config::Mistakes mistakes("the task to stand", 'T');
  Task task = read_task("striate: 1\nmission: stand\ndo:\n  - repeat:\n      - wait: {for: 60 s}\n",
                        mistakes, robot);
  mistakes.throw_if_any();
  return task;
}

Task task_for(const RobotMissionOptions& options, const RobotDescription& robot) {
  if (options.task.empty()) return standing_task(robot);
  std::vector<std::string> names;
  if (options.knowledge) names = options.knowledge->names();
  return load_task(options.task, robot, options.given, options.knowledge ? &names : nullptr);
}

/// Only the robot itself knows its limits; mistakes in the task are told before it is woken.
RealBody body_for(const RobotMissionOptions& options, const RobotSettings& settings) {
  (void)task_for(options, RobotDescription{});
  return options.body(settings);
}

}  // namespace

RealBody connect_pioneer(const RobotSettings& settings) {
  const pioneer::DevicePlaces& places = settings.pioneer.devices;
  if (places.base.empty() || places.camera.empty()) {
    throw UserError(
        "striate run: without --world the task is run with a real robot, and --robot FILE must say "
        "where its base and its camera are\n"
        "  hint: config/robots/pioneer.yaml does");
  }
  auto robot =
      std::make_unique<pioneer::PioneerRobot>(settings.pioneer, described_by(settings.robot));
  const auto hold = [&driver = robot->driver()] {
    const pioneer::HoldReason reason = driver.report().hold;
    return reason == pioneer::HoldReason::none ? std::string() : std::string(name_of(reason));
  };
  return {std::move(robot), places.base, hold};
}

RobotMission::RobotMission(const RobotMissionOptions& options)
    : options_(options),
      settings_(settings_for(options)),
      body_(body_for(options, settings_)),
      executive_(task_for(options, body_.robot->description())),
      watched_(std::make_unique<StopwatchRobot>(*body_.robot)),
      cycle_(std::make_unique<CognitiveCycle>(*watched_, settings_, executive_)),
      began_(body_.robot->clock().now()),
      stand_(began_) {
  if (!options_.knowledge) return;
  hand_over(std::move(*options_.knowledge), executive_.task(), settings_.long_term_memory, *cycle_);
  options_.knowledge.reset();
}

RunResult RobotMission::run(const EachCycle& each_cycle) {
  try {
    while (true) {
      const auto begin = std::chrono::steady_clock::now();
      const bool goes_on = cycle_->step();
      wall_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      ++cycles_;
      one_cycle_on();
      if (each_cycle(*this)) executive_.interrupt(MissionState::interrupted, "interrupted");
      if (!goes_on) break;
    }
  } catch (const std::exception& error) {
    lost_ = error.what();
  }
  watched_->stop();
  return result();
}

void RobotMission::one_cycle_on() {
  const Senses& senses = cycle_->trace().senses;
  const Odometry& odometry = senses.odometry;
  if (cycles_ > 1) {
    driven_m_ += std::hypot(odometry.pose.x_m - last_pose_.x_m, odometry.pose.y_m - last_pose_.y_m);
  }
  last_pose_ = odometry.pose;
  stand_.look(cycle_->trace());
}

double RobotMission::mean_cycle_ms() const {
  if (cycles_ == 0) return 0.0;
  return 1000.0 * (wall_s_ - watched_->sense_s()) / static_cast<double>(cycles_);
}

RunResult RobotMission::result() const {
  RunResult result;
  result.reason = executive_.reason();
  if (!lost_.empty()) {
    result.outcome = "lost";
    result.reason = lost_;
  } else if (executive_.state() == MissionState::interrupted) {
    result.outcome = "interrupted";
  } else if (executive_.state() == MissionState::succeeded) {
    result.outcome = "success";
    result.reason.clear();
  } else if (!executive_.ended()) {
    result.outcome = "body_ended";
    result.reason = "the recording or the robot has ended";
  } else {
    result.outcome = "task_failed";
  }
  result.reached_goal = result.outcome == "success";
  result.distance_m = driven_m_;
  result.duration_s = to_seconds(body_.robot->clock().now() - began_);
  result.emergency_stops = cycle_->limiter().emergency_stops();
  result.longest_stand_s = stand_.time_s();
  result.longest_stand_why = stand_.why();
  result.cycles = cycles_;
  result.mean_cycle_ms = mean_cycle_ms();
  result.realtime_factor = 1.0;
  result.world = body_.place;
  result.task = options_.task;
  result.emergency_layer = settings_.safety.emergency_layer;
  return result;
}

}  // namespace striate
