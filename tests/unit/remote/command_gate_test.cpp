#include "striate/platform/remote/command_gate.hpp"

#include <gtest/gtest.h>

namespace striate::remote {
namespace {

using namespace std::chrono_literals;

/// A robot that is felt and seen at once, and obeys.
struct Led {
  Inbox inbox{RemoteSettings{}};
  CommandGate gate{RemoteSettings{}};
  TimePoint now{10s};
  double obeyed_m_s = 0.0;

  /// Half a cycle: what the robot is told. @param decides whether a command comes
  double told_m_s(const char* line = "", bool decides = true) {
    now += 50ms;
    Odometry odometry;
    odometry.forward_m_s = obeyed_m_s;
    inbox.take_odometry(odometry, 0, now);
    StereoFrame frame;
    frame.stamp = now;
    frame.left = frame.right = cv::Mat3b(24, 32, cv::Vec3b(5, 5, 5));
    frame.focal_px = 30.0;
    frame.centre_u_px = 15.5;
    frame.centre_v_px = 11.5;
    frame.baseline_m = 0.1;
    inbox.take_frame(frame, now);
    gate.seen(now);
    MotorCommand command;
    command.forward_m_s = 0.3;
    if (decides) gate.command(command, now);
    const auto told = gate.tell(inbox, line, now);
    obeyed_m_s = told ? told->forward_m_s : 0.0;
    return obeyed_m_s;
  }
};

TEST(CommandGate, NothingIsToldBeforeTheFirstCommand) {
  Led robot;
  robot.told_m_s("", false);
  EXPECT_FALSE(robot.gate.tell(robot.inbox, "", robot.now));
  EXPECT_EQ(robot.told_m_s(), 0.3);
}

TEST(CommandGate, ALineThatSaysNothingIsATroubleAndOneThatBrokeHoldsUntilReset) {
  Led robot;
  EXPECT_EQ(robot.told_m_s(), 0.3);
  EXPECT_EQ(robot.told_m_s("the server is silent"), 0.0);
  EXPECT_EQ(robot.told_m_s(), 0.3) << "that alone ends by itself";
  robot.gate.line_broke();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(robot.told_m_s(), 0.0);
  EXPECT_TRUE(robot.gate.waits_for_reset());
  robot.gate.reset();
  EXPECT_EQ(robot.told_m_s(), 0.3);
}

TEST(CommandGate, ALineThatBreaksBeforeAnythingWasDrivenHoldsNothing) {
  Led robot;
  robot.gate.line_broke();
  EXPECT_EQ(robot.told_m_s(), 0.3);
}

TEST(CommandGate, ACommandIsNotDrivenAfterItsEndNorAfterItsLease) {
  Led robot;
  robot.told_m_s();
  robot.gate.end(robot.now);
  EXPECT_EQ(robot.told_m_s("", false), 0.0);
  robot.told_m_s();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(robot.told_m_s("", false), 0.3) << i;
  EXPECT_EQ(robot.told_m_s("", false), 0.0) << "0.5 s";
}

}  // namespace
}  // namespace striate::remote
