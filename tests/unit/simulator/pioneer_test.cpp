#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "striate/platform/simulator/simulated_pioneer.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "tests/unit/simulator/fake_images.hpp"

namespace striate::simulator {
namespace {

/// Sends the command every cycle for a while; false when the run ended.
bool drive(SimulatedPioneer& robot, Senses& senses, const MotorCommand& command, int cycles) {
  for (int i = 0; i < cycles; ++i) {
    robot.send(command);
    if (!robot.sense(senses)) return false;
  }
  return true;
}

TEST(SimulatedPioneer, StandsWhereTheWorldSaysUntilItIsTold) {
  SimulatedPioneer robot(straight_world(), 1, exact_start(), nullptr);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {}, 20));
  EXPECT_NEAR(robot.scene().robot.x_m, 1.0, 1e-6);
  EXPECT_NEAR(robot.scene().robot.y_m, 0.0, 1e-6);
  EXPECT_EQ(senses.now, TimePoint(std::chrono::seconds(2)));
  EXPECT_EQ(robot.clock().now(), senses.now);
  EXPECT_FALSE(senses.bumper);
}

TEST(SimulatedPioneer, DrivesOneMetreStraight) {
  SimulatedPioneer robot(straight_world(), 1, exact_start(), nullptr);
  Senses senses;
  // 0.5 m/s at 0.5 m/s2: half a metre lies in speeding up and slowing down, half a metre between.
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = 0.5}, 20));
  ASSERT_TRUE(drive(robot, senses, {}, 30));
  EXPECT_NEAR(robot.scene().robot.x_m, 2.0, 0.005);
  EXPECT_NEAR(robot.scene().robot.y_m, 0.0, 0.001);
  EXPECT_NEAR(robot.judge().distance_driven_m(), 1.0, 0.005);
}

TEST(SimulatedPioneer, TurnsOnTheSpotCounterClockwise) {
  SimulatedPioneer robot(straight_world(), 1, exact_start(), nullptr);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {.turn_rad_s = 0.5}, 20));
  ASSERT_TRUE(drive(robot, senses, {}, 20));
  EXPECT_NEAR(robot.scene().robot.heading_rad, 1.0, 0.01);
  EXPECT_NEAR(robot.scene().robot.x_m, 1.0, 0.002);
}

TEST(SimulatedPioneer, StandsWithinTheBrakingWay) {
  SimulatedPioneer robot(straight_world(), 1, exact_start(), nullptr);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = 0.75}, 40));
  EXPECT_NEAR(senses.odometry.forward_m_s, 0.75, 0.03);
  const double before = robot.scene().robot.x_m;
  ASSERT_TRUE(drive(robot, senses, {}, 30));
  const double way = robot.scene().robot.x_m - before;
  EXPECT_GT(way, 0.75 * 0.75 / (2 * 0.5));
  EXPECT_LT(way, 0.75 * 0.75 / (2 * 0.5) + 0.75 * 0.08);
  EXPECT_EQ(robot.scene().forward_m_s, 0.0);
}

TEST(SimulatedPioneer, StopsByItselfWithoutCommands) {
  SimulatedPioneer robot(straight_world(), 1, exact_start(), nullptr);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = 0.4}, 20));
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(robot.sense(senses));
  EXPECT_NEAR(robot.scene().forward_m_s, 0.4, 1e-3) << "the watchdog waits 500 ms";
  for (int i = 0; i < 16; ++i) ASSERT_TRUE(robot.sense(senses));
  EXPECT_EQ(robot.scene().forward_m_s, 0.0);
}

TEST(SimulatedPioneer, ACommandThatIsNoNumberStopsTheWheels) {
  SimulatedPioneer robot(straight_world(), 1, exact_start(), nullptr);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = 0.4}, 20));
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = std::nan(""), .pan_rad = std::nan("")}, 20));
  EXPECT_EQ(robot.scene().forward_m_s, 0.0);
  EXPECT_TRUE(std::isfinite(robot.scene().head.pan_rad));
}

TEST(SimulatedPioneer, StopsWhenTheLinkDies) {
  SimulatorSettings settings = exact_start();
  settings.faults.link_stops_at_s = 3.0;
  SimulatedPioneer robot(straight_world(), 1, settings, nullptr);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = 0.4}, 29));
  EXPECT_GT(robot.scene().forward_m_s, 0.39);
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = 0.4}, 20));
  EXPECT_EQ(robot.scene().forward_m_s, 0.0);
}

TEST(SimulatedPioneer, StopNeedsNoSenseAndMayBeCalledTwice) {
  SimulatedPioneer robot(straight_world(), 1, exact_start(), nullptr);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = 0.4, .pan_rad = 0.3}, 20));
  robot.stop();
  robot.stop();
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(robot.sense(senses));
  EXPECT_EQ(robot.scene().forward_m_s, 0.0);
  EXPECT_NEAR(robot.scene().head.pan_rad, 0.3, 1e-9) << "the head stays";
}

TEST(SimulatedPioneer, TheBumperEndsTheRunAndTheCollisionIsKept) {
  World world = straight_world();
  WorldObstacle box;
  box.name = "red_box";
  box.at = {6.0, 0.1};
  box.size_x_m = box.size_y_m = box.size_z_m = 0.5;
  world.obstacles.push_back(box);
  FakeImages pictures;
  SimulatedPioneer robot(world, 1, exact_start(), &pictures);
  Senses senses;
  EXPECT_FALSE(drive(robot, senses, {.forward_m_s = 0.5}, 200));
  EXPECT_TRUE(senses.bumper);
  EXPECT_EQ(robot.judge().outcome(), Verdict::collided);
  ASSERT_EQ(robot.judge().collisions().size(), 1u);
  const Collision& collision = robot.judge().collisions()[0];
  EXPECT_EQ(collision.hit, "red_box");
  EXPECT_FALSE(collision.moving);
  EXPECT_NEAR(collision.along_m, 6.0 - 0.25 - 0.21, 0.01);
  EXPECT_NEAR(collision.light_level, 0.2, 1e-12);
  EXPECT_NEAR(collision.forward_m_s, 0.5, 0.05);
}

TEST(SimulatedPioneer, OneTouchIsOneCollisionAndStallsTheMotors) {
  SimulatorSettings settings = exact_start();
  settings.judge.ends_at_collision = false;
  settings.judge.ends_at_goal = false;
  SimulatedPioneer robot(straight_world(4.0), 1, settings, nullptr);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = 0.5}, 150));
  EXPECT_TRUE(senses.bumper);
  EXPECT_TRUE(senses.motors_stalled);
  ASSERT_EQ(robot.judge().collisions().size(), 1u);
  EXPECT_EQ(robot.judge().collisions()[0].hit, "wall");
  EXPECT_LT(robot.scene().robot.x_m, 4.0 - 0.20) << "the robot does not enter the wall";
  ASSERT_TRUE(drive(robot, senses, {.forward_m_s = -0.3}, 20));
  EXPECT_FALSE(senses.bumper);
  EXPECT_FALSE(senses.motors_stalled);
}

TEST(SimulatedPioneer, PassingTheGoalLineEndsTheRun) {
  World world = straight_world();
  world.goal_beyond_m = 3.0;
  SimulatedPioneer robot(world, 1, exact_start(), nullptr);
  Senses senses;
  EXPECT_FALSE(drive(robot, senses, {.forward_m_s = 0.5}, 100));
  EXPECT_EQ(robot.judge().outcome(), Verdict::reached_goal);
  EXPECT_NEAR(robot.judge().in_corridor().x_m, 3.0, 0.01);
  EXPECT_TRUE(robot.judge().collisions().empty());
  EXPECT_NEAR(robot.judge().nearest_pass_m(), 0.7, 0.01) << "the start wall is behind the robot";
}

TEST(SimulatedPioneer, TheTimeLimitEndsTheRun) {
  SimulatorSettings settings = exact_start();
  settings.judge.time_limit_s = 2.0;
  SimulatedPioneer robot(straight_world(), 1, settings, nullptr);
  Senses senses;
  EXPECT_FALSE(drive(robot, senses, {}, 100));
  EXPECT_EQ(robot.judge().outcome(), Verdict::time_up);
  EXPECT_EQ(senses.now, TimePoint(std::chrono::seconds(2)));
}

TEST(SimulatedPioneer, ImagesArriveLateWithTheStampOfTheirLight) {
  FakeImages pictures;
  SimulatedPioneer robot(straight_world(), 1, exact_start(), &pictures);
  Senses senses;
  ASSERT_TRUE(robot.sense(senses));
  ASSERT_TRUE(robot.sense(senses));
  ASSERT_FALSE(senses.stereo.left.empty());
  const double age = to_seconds(senses.now - senses.stereo.stamp);
  EXPECT_GE(age, 0.085);
  EXPECT_LT(age, 0.185);
  EXPECT_NEAR(to_seconds(senses.stereo.stamp), pictures.scenes[senses.stereo.left(0, 0)[0]].time_s,
              1e-9);
}

TEST(SimulatedPioneer, AnImageKnowsWhereTheHeadLooked) {
  FakeImages pictures;
  SimulatedPioneer robot(straight_world(), 1, exact_start(), &pictures);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {.pan_rad = 1.0, .tilt_rad = -0.2}, 4));
  const SceneState& scene = pictures.scenes[senses.stereo.left(0, 0)[0]];
  EXPECT_GT(scene.head.pan_rad, 0.1);
  EXPECT_LT(scene.head.pan_rad, 0.7) << "the servo is still under way";
  EXPECT_NEAR(senses.stereo.head.pan_rad, scene.head.pan_rad, radians(0.3));
  EXPECT_GT(senses.head.pan_rad, senses.stereo.head.pan_rad + 0.1) << "the image is older";
  ASSERT_TRUE(drive(robot, senses, {.pan_rad = 9.0, .tilt_rad = -9.0}, 30));
  EXPECT_NEAR(senses.head.pan_rad, robot.description().max_pan_rad, radians(0.3));
  EXPECT_NEAR(senses.head.tilt_rad, -robot.description().max_tilt_rad, radians(0.3));
}

TEST(SimulatedPioneer, NoImageComesAfterTheCameraHasStopped) {
  SimulatorSettings settings = exact_start();
  settings.faults.camera_stops_at_s = 1.0;
  settings.faults.camera_returns_at_s = 3.0;
  FakeImages pictures;
  SimulatedPioneer robot(straight_world(), 1, settings, &pictures);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {}, 25));
  EXPECT_LT(to_seconds(senses.stereo.stamp), 1.0);
  EXPECT_GT(to_seconds(senses.now - senses.stereo.stamp), 1.4);
  ASSERT_TRUE(drive(robot, senses, {}, 10));
  EXPECT_LT(to_seconds(senses.now - senses.stereo.stamp), 0.2);
}

TEST(SimulatedPioneer, LosesTheShareOfImagesThatItIsToldTo) {
  SimulatorSettings settings = exact_start();
  settings.faults.image_loss = 0.3;
  FakeImages pictures;
  SimulatedPioneer robot(straight_world(), 5, settings, &pictures);
  Senses senses;
  ASSERT_TRUE(drive(robot, senses, {}, 1000));
  EXPECT_NEAR(static_cast<double>(pictures.scenes.size()), 700.0, 50.0);
}

TEST(SimulatedPioneer, TheBatterySinks) {
  SimulatedPioneer robot(straight_world(), 1, exact_start(), nullptr);
  Senses senses;
  ASSERT_TRUE(robot.sense(senses));
  const double first = senses.battery_v;
  ASSERT_TRUE(drive(robot, senses, {}, 600));
  EXPECT_NEAR(first - senses.battery_v, 0.01, 0.001);
}

/// Every number of the senses, bit by bit.
void append(std::vector<std::uint64_t>& bits, double value) {
  std::uint64_t word = 0;
  std::memcpy(&word, &value, sizeof word);
  bits.push_back(word);
}

std::vector<std::uint64_t> stream(std::uint64_t seed) {
  World world = load_world(STRIATE_SOURCE_DIR "/config/worlds/corridor_a.yaml");
  FakeImages pictures;
  SimulatorSettings settings;
  settings.judge.ends_at_collision = false;
  SimulatedPioneer robot(world, seed, settings, &pictures);
  Senses senses;
  std::vector<std::uint64_t> bits;
  for (int i = 0; i < 600; ++i) {
    robot.send({.forward_m_s = 0.4, .turn_rad_s = 0.1 * std::sin(0.1 * i), .pan_rad = 0.2});
    robot.sense(senses);
    append(bits, senses.odometry.pose.x_m);
    append(bits, senses.odometry.pose.y_m);
    append(bits, senses.odometry.pose.heading_rad);
    for (const RangeReading& reading : senses.sonar.readings) append(bits, reading.distance_m);
    for (const RangeReading& reading : senses.laser.readings) append(bits, reading.distance_m);
    for (const PersonState& person : robot.scene().people) append(bits, person.pose.x_m);
  }
  return bits;
}

TEST(SimulatedPioneer, TheSameSeedGivesTheSameSensesToTheLastBit) {
  EXPECT_EQ(stream(7), stream(7));
  EXPECT_NE(stream(7), stream(8));
}

}  // namespace
}  // namespace striate::simulator
