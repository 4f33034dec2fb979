#include "app/ros/ros_bodies.hpp"

#include <utility>

#include "app/renderer_pictures.hpp"
#include "app/ros/real_time_robot.hpp"
#include "platform/ros/ros_robot.hpp"
#include "platform/simulator/world_reader.hpp"

namespace striate {
namespace {

/// The simulated Pioneer with all that it lives in.
class SimulatedBody final : public Robot {
 public:
  SimulatedBody(const RobotSettings& settings, const std::string& world, std::uint64_t seed)
      : world_(simulator::load_world(world)),
        plan_(simulator::build_floor_plan(world_)),
        pictures_(world_, plan_, settings.camera, seed),
        body_(world_, seed, settings.simulator, &pictures_, simulated_robot(settings)) {}
  [[nodiscard]] const RobotDescription& description() const override { return body_.description(); }
  [[nodiscard]] const Clock& clock() const override { return body_.clock(); }
  bool sense(Senses& senses) override { return body_.sense(senses); }
  void send(const MotorCommand& command) override { body_.send(command); }
  void stop() noexcept override { body_.stop(); }

 private:
  simulator::World world_;
  simulator::FloorPlan plan_;
  RendererPictures pictures_;
  simulator::SimulatedPioneer body_;
};

}  // namespace

RealBody simulated_body(const RobotSettings& settings, const std::string& world,
                        std::uint64_t seed) {
  RobotSettings endless = settings;
  endless.simulator.judge = {
      .ends_at_collision = false, .ends_at_goal = false, .time_limit_s = 0.0};
  auto body = std::make_unique<SimulatedBody>(endless, world, seed);
  return {std::make_unique<RealTimeRobot>(std::move(body)), world, {}};
}

RealBody ros_body(const RobotSettings& settings) {
  auto robot = std::make_unique<ros1::RosRobot>(settings.ros, simulated_robot(settings));
  const auto hold = [&gate = *robot] { return gate.hold(); };
  return {std::move(robot), "ROS", hold};
}

}  // namespace striate
