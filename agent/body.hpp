#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "striate/agent/robot_settings.hpp"
#include "striate/perception/stereo/disparity_source.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/simulator/judge.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::agent {

class SimulatedBody;

/// A body that is awake, and what is known about it.
struct Body {
  std::unique_ptr<Robot> robot;
  std::string place = {};  ///< where it is: an address, a world, "ROS", a file
  /// Why the body's own gate holds it or slows it; "": it does not. May be empty.
  std::function<std::string()> hold = {};
  /// Whether it holds until `reset`. May be empty: it never does.
  std::function<bool()> waits_for_reset = {};
  /// Somebody has looked at the robot: ends what its gate has latched. May be empty.
  std::function<void()> reset = {};
  /// Who watches it and knows the truth; nullptr: nobody but the task. Lives as long as the robot.
  const simulator::Judge* judge = nullptr;
  /// A baseline's disparities; nullptr: Striate's own stereo. Lives as long as the robot.
  perception::DisparitySource* disparities = nullptr;
  /// The robot as the simulated one that it is, for what images and results tell of it; nullptr:
  /// it is another, or nobody is to judge it.
  const SimulatedBody* simulated = nullptr;
};

/// Which body a mission is to have.
struct BodySource {
  /// Wakes it; may change what the mind sees by, as a baseline does.
  /// @throws UserError, std::runtime_error when it does not come up
  std::function<Body(RobotSettings&)> wake;
  tasks::GivenVariables given = {};  ///< what tasks are told of the place: how far it is
  /// What is known of it before it is woken; none: what the settings say of their robot.
  std::optional<RobotDescription> description = {};
};

/// The Pioneer whose devices the settings name. @throws UserError, when woken, where they do not.
[[nodiscard]] BodySource real_pioneer();

}  // namespace striate::agent
