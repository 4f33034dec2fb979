#include "app/ros/ros_bodies.hpp"

#include <utility>

#include "app/ros/real_time_robot.hpp"
#include "platform/ros/ros_robot.hpp"
#include "platform/simulator/world_reader.hpp"

namespace striate {

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
    auto robot = std::make_unique<ros1::RosRobot>(settings.ros);
    const auto hold = [&gate = *robot] { return gate.hold(); };
    return {.robot = std::move(robot), .place = "ROS", .hold = hold};
  }};
}

}  // namespace striate
