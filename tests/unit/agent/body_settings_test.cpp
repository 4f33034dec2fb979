#include "striate/agent/body_settings.hpp"

#include <gtest/gtest.h>

#include "striate/agent/robot_settings.hpp"
#include "striate/behaviours/control/footprint.hpp"
#include "striate/platform/simulator/shapes.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::agent {
namespace {

const std::string kRobots = std::string(STRIATE_SOURCE_DIR "/config/robots/");

TEST(BodySettings, WithoutAFileAreThePioneer) {
  const RobotDescription robot = simulated_robot({});
  const RobotDescription pioneer;
  EXPECT_EQ(robot.front_m, pioneer.front_m);
  EXPECT_EQ(robot.rear_m, pioneer.rear_m);
  EXPECT_EQ(robot.half_width_m, pioneer.half_width_m);
  EXPECT_EQ(robot.corner_m, pioneer.corner_m);
  EXPECT_EQ(robot.max_forward_m_s, pioneer.max_forward_m_s);
  EXPECT_EQ(robot.max_turn_rad_s, pioneer.max_turn_rad_s);
  EXPECT_EQ(robot.camera_height_m, pioneer.camera_height_m);
  EXPECT_EQ(robot.view_rad, pioneer.view_rad);
  EXPECT_EQ(robot.resting_tilt_rad, pioneer.resting_tilt_rad);
}

TEST(BodySettings, TheCamerasSettingsReachTheDescription) {
  const reference::TemporaryFolder folder;
  const std::string file = folder.write("r.yaml",
                                        "camera: {field: 60 deg, height: 0.9 m, forward: 5 cm, "
                                        "resting_tilt: -3 deg}\n");
  const RobotDescription robot = simulated_robot(load_robot_settings(file));
  EXPECT_NEAR(robot.view_rad, radians(60.0), 1e-12);
  EXPECT_EQ(robot.camera_height_m, 0.9);
  EXPECT_EQ(robot.camera_forward_m, 0.05);
  EXPECT_NEAR(robot.resting_tilt_rad, radians(-3.0), 1e-12);
}

TEST(BodySettings, TheShippedRobotsHaveTheOutlinesOfTheirKinds) {
  const RobotDescription turtle = simulated_robot(load_robot_settings(kRobots + "turtlebot.yaml"));
  EXPECT_LT(turtle.half_width_m, 0.19);
  EXPECT_LE(turtle.max_forward_m_s, 0.65);
  const RobotDescription p3at = simulated_robot(load_robot_settings(kRobots + "p3at.yaml"));
  EXPECT_NEAR(p3at.front_m + p3at.rear_m, 0.508, 1e-9);
  EXPECT_NEAR(2.0 * p3at.half_width_m, 0.497, 1e-9);
}

TEST(BodySettings, MindAndSimulatorMeasureFromTheSameOutline) {
  const RobotDescription turtle = simulated_robot(load_robot_settings(kRobots + "turtlebot.yaml"));
  const simulator::ConvexShape wall = simulator::rectangle({0.5, 0.0, 0.0}, 0.2, 2.0);
  const double gap_m = simulator::distance_m(simulator::robot_footprint(turtle), wall);
  EXPECT_NEAR(gap_m, 0.4 - turtle.front_m, 1e-9);
  EXPECT_NEAR(behaviours::Footprint(turtle).distance_m({0.4, 0.0}), gap_m, 1e-9);
}

TEST(BodySettings, ACornerTooLongForTheOutlineIsShortened) {
  BodySettings settings;
  settings.outline = {.front_m = 0.1, .rear_m = 0.1, .half_width_m = 0.1, .corner_m = 0.5};
  const simulator::ConvexShape shape = simulator::robot_footprint(described_by(settings));
  double twice_area = 0.0;
  for (std::size_t i = 0; i < shape.corners.size(); ++i) {
    const Point2& a = shape.corners[i];
    const Point2& b = shape.corners[(i + 1) % shape.corners.size()];
    twice_area += a.x_m * b.y_m - a.y_m * b.x_m;
  }
  EXPECT_GT(twice_area, 0.0) << "corners stay counter-clockwise";
}

TEST(RetiredSettings, AreStillAcceptedWithAWarning) {
  const reference::TemporaryFolder folder;
  const std::string file =
      folder.write("r.yaml", "memory:\n  occupancy: {disparity_metre: 24.4}\n");
  std::string warnings;
  EXPECT_NO_THROW((void)load_robot_settings(file, &warnings));
  EXPECT_NE(warnings.find("r.yaml:2:15: warning: 'disparity_metre' has no effect any more"),
            std::string::npos)
      << warnings;
}

}  // namespace
}  // namespace striate::agent
