#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "striate/agent/mission.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/platform/simulator/static_shapes.hpp"
#include "tests/scenarios/striate_process.hpp"

/// Robots of other sizes drive the short corridor by vision alone, by their YAML and nothing else.
namespace striate::scenarios {
namespace {

agent::MissionOptions by_vision_alone(const std::string& robot_file) {
  agent::MissionOptions options;
  options.task = kRoot + "config/tasks/corridor.yaml";
  options.robot = kRoot + "config/robots/" + robot_file;
  options.emergency_layer = false;
  return options;
}

agent::BodySource in_the_short_corridor() {
  agent::WorldOptions options;
  options.world = kRoot + "config/worlds/short.yaml";
  options.seed = 3;
  return agent::simulated_pioneer(options);
}

/// How near a body of this outline came to wall or obstacle, by the poses of a run.
class Passed {
 public:
  Passed(const RobotDescription& body, const agent::SimulatedBody& simulated)
      : outline_(simulator::robot_footprint(body)),
        things_(simulator::standing_shapes(simulated.world(), simulated.plan())) {
    for (simulator::StaticShape& wall : simulator::wall_shapes(simulated.plan())) {
      things_.push_back(std::move(wall));
    }
  }
  void at(const Pose2& pose) {
    const simulator::ConvexShape body = simulator::moved(outline_, pose);
    for (const simulator::StaticShape& thing : things_) {
      nearest_m_ = std::min(nearest_m_, simulator::distance_m(body, thing.shape));
    }
  }
  [[nodiscard]] double nearest_m() const { return nearest_m_; }

 private:
  simulator::ConvexShape outline_;
  std::vector<simulator::StaticShape> things_;
  double nearest_m_ = std::numeric_limits<double>::infinity();
};

class OtherRobots : public testing::TestWithParam<const char*> {};

TEST_P(OtherRobots, ReachTheGoalByVisionAloneAndTouchNothing) {
  agent::Mission mission(by_vision_alone(GetParam()), in_the_short_corridor());
  const RobotDescription robot = mission.body().description();
  Passed own(robot, *mission.simulated());
  Passed pioneer({}, *mission.simulated());
  double fastest_m_s = 0.0;
  const agent::RunResult result = mission.run([&](const agent::Mission& running) {
    own.at(running.simulated()->judge().now().pose);
    pioneer.at(running.simulated()->judge().now().pose);
    fastest_m_s = std::max(fastest_m_s, running.cycle().trace().sent.forward_m_s);
    return false;
  });
  EXPECT_EQ(result.outcome, agent::RunOutcome::success) << result.reason;
  EXPECT_TRUE(result.collisions.empty());
  EXPECT_LE(fastest_m_s, robot.max_forward_m_s);
  // The judge measures from this robot's outline and not from the Pioneer's.
  EXPECT_NEAR(result.nearest_pass_m, own.nearest_m(), 0.02);
  EXPECT_GT(std::abs(result.nearest_pass_m - pioneer.nearest_m()), 0.025);
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, OtherRobots,
                         testing::Values("turtlebot.yaml", "p3at.yaml"));

}  // namespace
}  // namespace striate::scenarios
