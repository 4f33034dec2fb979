#include "striate/agent/ros/ros_bodies.hpp"

#include <utility>

#include "striate/agent/ros/real_time_robot.hpp"
#include "striate/platform/ros/ros_robot.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace striate::agent {

BodySource pioneer_in_real_time(const WorldOptions& options) {
  const auto wake = [options, world = simulator::load_world(options.world)](
                        const RobotSettings& settings) -> Body {
    RobotSettings endless = settings;
    endless.simulator.judge = {
        .ends_at_collision = false, .ends_at_goal = false, .time_limit_s = 0.0};
    auto robot = std::make_unique<SimulatedBody>(endless, world, options);
    return {.robot = std::make_unique<RealTimeRobot>(std::move(robot)), .place = options.world};
  };
  return {.wake = wake};
}

BodySource robot_behind_ros() {
  return {.wake = [](const RobotSettings& settings) -> Body {
    auto robot = std::make_unique<ros::RosRobot>(settings.ros, simulated_robot(settings));
    const auto hold = [&gate = *robot] { return gate.hold(); };
    const auto waits = [&gate = *robot] { return gate.waits_for_reset(); };
    const auto reset = [&gate = *robot] { gate.reset(); };
    return {.robot = std::move(robot),
            .place = "ROS",
            .hold = hold,
            .waits_for_reset = waits,
            .reset = reset};
  }};
}

}  // namespace striate::agent
