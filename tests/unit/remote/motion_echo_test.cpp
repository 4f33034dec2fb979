#include "striate/platform/remote/motion_echo.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace striate::remote {
namespace {

using namespace std::chrono_literals;

/// Drives a robot that obeys at once over a line that is so late each way.
/// @returns for how long it was told to move
Duration told_to_move(Duration there, Duration back) {
  MotionEcho echo(1s);
  std::deque<std::pair<TimePoint, double>> to_robot;
  std::deque<std::pair<TimePoint, double>> to_us;
  double drives_m_s = 0.0;
  Duration moved{};
  for (TimePoint now(1s); now < TimePoint(31s); now += 50ms) {
    while (!to_robot.empty() && to_robot.front().first <= now) {
      drives_m_s = to_robot.front().second;
      to_robot.pop_front();
    }
    to_us.emplace_back(now + back, drives_m_s);
    while (!to_us.empty() && to_us.front().first <= now) {
      Odometry odometry;
      odometry.forward_m_s = to_us.front().second;
      echo.felt(odometry);
      to_us.pop_front();
    }
    MotorCommand command;
    command.forward_m_s = echo.holds() ? 0.0 : 0.3;
    echo.commanded(command, now);
    to_robot.emplace_back(now + there, command.forward_m_s);
    if (command.forward_m_s > 0.0) moved += 50ms;
  }
  return moved;
}

TEST(MotionEcho, ARobotThatFollowsIsDriven) {
  EXPECT_EQ(told_to_move(0ms, 0ms), 30s);
  EXPECT_EQ(told_to_move(200ms, 300ms), 30s);
}

TEST(MotionEcho, ALineThatIsLateFromTheBeginningHolds) {
  EXPECT_LE(told_to_move(3s, 0ms), 1200ms);
  EXPECT_LE(told_to_move(0ms, 3s), 1200ms);
  EXPECT_LE(told_to_move(800ms, 800ms), 1200ms);
}

TEST(MotionEcho, StandingOrCreepingIsNoQuestion) {
  MotionEcho echo(1s);
  MotorCommand creeps;
  creeps.forward_m_s = 0.01;
  for (TimePoint now(1s); now < TimePoint(9s); now += 50ms) echo.commanded(creeps, now);
  EXPECT_FALSE(echo.holds());
}

}  // namespace
}  // namespace striate::remote
