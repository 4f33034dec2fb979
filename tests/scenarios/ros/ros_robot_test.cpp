#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Twist.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <stereo_msgs/DisparityImage.h>
#include <tf2_msgs/TFMessage.h>

#include "tests/scenarios/ros/through_ros.hpp"

namespace striate::scenarios {
namespace {

TEST_F(ThroughRos, TheSimulatedPioneerIsFeltAndDrivenAndStandsWhenTheCommandsEnd) {
  const auto server = serve("config/worlds/empty.yaml");
  ros::RosRobot robot(settings(), {}, 30s);
  Senses senses;
  const MotorCommand forward{0.3, 0.0, 0.2, -0.2};
  const double took_s = until(robot, senses, 40.0, [&] {
    robot.send(forward);
    return senses.odometry.pose.x_m > 1.0;
  });
  ASSERT_GT(senses.odometry.pose.x_m, 1.0) << took_s << " s; " << text_of(log("serve"));
  EXPECT_EQ(senses.stereo.left.cols, 160);
  EXPECT_EQ(senses.stereo.right.size(), senses.stereo.left.size());
  EXPECT_NEAR(senses.stereo.focal_px, 203.0, 3.0) << "43 degrees";
  EXPECT_NEAR(senses.stereo.baseline_m, 0.12, 1e-6);
  EXPECT_NEAR(senses.head.pan_rad, 0.2, 0.05);
  EXPECT_NEAR(senses.stereo.head.tilt_rad, -0.2, 0.05);
  EXPECT_GE(senses.sonar.readings.size(), 4u);
  EXPECT_GE(senses.laser.readings.size(), 90u);
  EXPECT_EQ(robot.hold(), "");

  const double stop_s = until(robot, senses, 5.0, [&] { return stands(senses); });
  RecordProperty("seconds_to_stand", std::to_string(stop_s));
  EXPECT_TRUE(stands(senses));
  EXPECT_LT(stop_s, 2.5) << "the lease of 0.5 s, braking from 0.3 m/s, and a loaded machine";
  EXPECT_EQ(robot.hold(), "no fresh command");

  robot.reset();  // nothing was commanded in the midst of motion
  server->kill(SIGKILL);
  robot.send(forward);
  EXPECT_THROW(until(robot, senses, 10.0,
                     [&] {
                       robot.send(forward);
                       return false;
                     }),
               std::runtime_error);
  EXPECT_THAT(robot.hold(), testing::StartsWith("no "));
}

TEST_F(ThroughRos, AMissionDrivesByVisionAndTheRobotStandsWhenItIsKilled) {
  const auto server = serve("config/worlds/short.yaml");
  ros::RosRobot onlooker(settings(), {}, 30s);
  Senses senses;
  auto first = mission("2 m");
  EXPECT_EQ(first->wait(60s), 0) << text_of(log("mission"));
  onlooker.sense(senses);
  EXPECT_GT(senses.odometry.pose.x_m, 1.7);
  EXPECT_THAT(text_of(log("mission")), testing::HasSubstr("success"));

  auto second = mission("20 m");
  until(onlooker, senses, 30.0, [&] { return senses.odometry.forward_m_s > 0.1; });
  ASSERT_GT(senses.odometry.forward_m_s, 0.1) << text_of(log("mission"));
  second->kill(SIGKILL);
  const double stop_s = until(onlooker, senses, 5.0, [&] { return stands(senses); });
  RecordProperty("seconds_to_stand", std::to_string(stop_s));
  EXPECT_TRUE(stands(senses));
  EXPECT_LT(stop_s, 2.5);

  auto third = mission("20 m");
  until(onlooker, senses, 30.0, [&] { return senses.odometry.forward_m_s > 0.1; });
  ASSERT_GT(senses.odometry.forward_m_s, 0.1) << text_of(log("mission"));
  server->kill(SIGKILL);
  EXPECT_EQ(third->wait(20s), 1) << "the robot is lost";
  EXPECT_THAT(text_of(log("mission")), testing::HasSubstr("the robot is lost"));
}

/// Hears whether `cmd_vel` says zero.
class Ear {
 public:
  Ear() {
    node_.setCallbackQueue(&queue_);
    const boost::function<void(const geometry_msgs::TwistConstPtr&)> take = [this](const auto& to) {
      zero_ = to->linear.x == 0.0 && to->angular.z == 0.0;
    };
    subscriber_ = node_.subscribe<geometry_msgs::Twist>("cmd_vel", 1, take);
  }
  /// Seconds until the next zero that comes.
  double until_zero_s(double limit_s) {
    queue_.callAvailable();  // what was said before
    zero_ = false;
    const auto begin = Steady::now();
    const auto since_s = [&] {
      return std::chrono::duration<double>(Steady::now() - begin).count();
    };
    while (!zero_ && since_s() < limit_s) queue_.callAvailable(::ros::WallDuration(0.01));
    return since_s();
  }

 private:
  ::ros::CallbackQueue queue_;
  ::ros::NodeHandle node_;
  ::ros::Subscriber subscriber_;
  bool zero_ = false;
};

TEST_F(ThroughRos, OfAMissionThatDiesOrHangsAnotherNodeSaysZeroOnCmdVel) {
  const auto server = serve("config/worlds/short.yaml");
  ros::RosRobot onlooker(settings(), {}, 30s);
  Senses senses;
  Ear ear;
  for (const int signal : {SIGKILL, SIGSEGV, SIGSTOP}) {
    auto program = mission("20 m");
    until(onlooker, senses, 30.0, [&] { return senses.odometry.forward_m_s > 0.1; });
    ASSERT_GT(senses.odometry.forward_m_s, 0.1) << text_of(log("mission"));
    program->kill(signal);
    const double zero_s = ear.until_zero_s(3.0);
    RecordProperty("seconds_to_zero_" + std::to_string(signal), std::to_string(zero_s));
    EXPECT_LT(zero_s, 0.45) << signal;
    until(onlooker, senses, 5.0, [&] { return stands(senses); });
    EXPECT_TRUE(stands(senses));
    program->kill(SIGKILL);
  }
}

/// What an onlooker in ROS gets.
struct Heard {
  stereo_msgs::DisparityImageConstPtr disparity;
  diagnostic_msgs::DiagnosticArrayConstPtr diagnostics;
  tf2_msgs::TFMessageConstPtr tf;
};

TEST_F(ThroughRos, DisparityDiagnosticsAndFramesAreShown) {
  const auto server = serve("config/worlds/short.yaml");
  ros::RosRobot robot(settings(), {}, 30s);  // joins ROS
  ::ros::CallbackQueue queue;
  ::ros::NodeHandle node;
  node.setCallbackQueue(&queue);
  Heard heard;
  const boost::function<void(const stereo_msgs::DisparityImageConstPtr&)> on_disparity =
      [&](const auto& message) { heard.disparity = message; };
  const boost::function<void(const diagnostic_msgs::DiagnosticArrayConstPtr&)> on_diagnostics =
      [&](const auto& message) { heard.diagnostics = message; };
  const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> on_tf = [&](const auto& message) {
    heard.tf = message;
  };
  const auto a = node.subscribe<stereo_msgs::DisparityImage>("stereo/disparity", 1, on_disparity);
  const auto b =
      node.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1, on_diagnostics);
  const auto c = node.subscribe<tf2_msgs::TFMessage>("/tf", 1, on_tf);
  const auto end = Steady::now() + 20s;
  while (Steady::now() < end && !(heard.disparity && heard.diagnostics && heard.tf)) {
    queue.callAvailable(::ros::WallDuration(0.1));
  }
  ASSERT_TRUE(heard.disparity && heard.diagnostics && heard.tf) << text_of(log("serve"));
  EXPECT_EQ(heard.disparity->image.encoding, "32FC1");
  EXPECT_NEAR(heard.disparity->T, 0.12F, 1e-6F);
  EXPECT_EQ(heard.disparity->image.data.size(),
            heard.disparity->image.width * heard.disparity->image.height * 4);
  ASSERT_EQ(heard.diagnostics->status.size(), 1u);
  EXPECT_EQ(heard.diagnostics->status[0].name, "striate: mission");
  ASSERT_EQ(heard.tf->transforms.size(), 3u);
  EXPECT_EQ(heard.tf->transforms[0].header.frame_id, "odom");
  EXPECT_EQ(heard.tf->transforms[0].child_frame_id, "base_link");
  EXPECT_NEAR(heard.tf->transforms[1].transform.translation.z, 1.2, 1e-9);
}

TEST_F(ThroughRos, ARobotThatIsNotThereIsNamedByItsTopic) {
  try {
    ros::RosRobot robot(settings(), {}, 300ms);
    FAIL() << "nobody publishes";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no odometry came on /odom"));
  }
}

}  // namespace
}  // namespace striate::scenarios
