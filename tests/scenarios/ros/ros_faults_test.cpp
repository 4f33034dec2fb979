#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "striate/platform/ros/messages.hpp"
#include "striate/platform/ros/node.hpp"
#include "tests/scenarios/ros/through_ros.hpp"

/// What stops a robot that is only reachable through ROS, and how soon zero is on `cmd_vel`.
namespace striate::scenarios {
namespace {

/// A robot that obeys at once: 20 times a second odometry and, while it has eyes, an image pair.
class FakeRobot {
 public:
  FakeRobot() {
    ros::join_ros("fake");
    node_ = std::make_unique<::ros::NodeHandle>();
    node_->setCallbackQueue(&queue_);
    odometry_ = node_->advertise<nav_msgs::Odometry>("odom", 1);
    left_ = node_->advertise<sensor_msgs::Image>("stereo/left/image_rect_color", 1);
    right_ = node_->advertise<sensor_msgs::Image>("stereo/right/image_rect_color", 1);
    const boost::function<void(const geometry_msgs::TwistConstPtr&)> take =
        [this](const auto& twist) {
          forward_m_s = twist->linear.x;
          if (twist->linear.x == 0.0) return;
          const std::lock_guard lock(mutex_);
          last_drive_ = Steady::now();
        };
    listens_ = node_->subscribe<geometry_msgs::Twist>("cmd_vel", 1, take);
    timer_ = node_->createSteadyTimer(::ros::WallDuration(0.05),
                                      [this](const ::ros::SteadyTimerEvent&) { tell(); });
    spinner_ = std::make_unique<::ros::AsyncSpinner>(1, &queue_);
    spinner_->start();
  }
  ~FakeRobot() {
    timer_.stop();
    spinner_->stop();
  }

  /// How long after `moment` it was last told to move.
  [[nodiscard]] double drove_for_s(Steady::time_point moment) {
    const std::lock_guard lock(mutex_);
    return std::chrono::duration<double>(last_drive_ - moment).count();
  }

  std::atomic<double> forward_m_s{0.0};
  std::atomic<bool> has_eyes{true};
  std::atomic<bool> is_deaf{false};  ///< does not move, whatever it is told
  std::atomic<double> odometry_late_s{0.0};

 private:
  void tell() {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ::ros::Time::now() - ::ros::Duration(odometry_late_s);
    odometry.pose.pose.orientation.w = 1.0;
    odometry.twist.twist.linear.x = is_deaf ? 0.0 : forward_m_s.load();
    odometry_.publish(odometry);
    if (!has_eyes) return;
    sensor_msgs::Image image;
    image.header.stamp = ::ros::Time::now();
    ros::write(cv::Mat3b(120, 160, cv::Vec3b(90, 90, 90)), image);
    left_.publish(image);
    right_.publish(image);
  }

  ::ros::CallbackQueue queue_;
  std::unique_ptr<::ros::NodeHandle> node_;
  ::ros::Publisher odometry_, left_, right_;
  ::ros::Subscriber listens_;
  ::ros::SteadyTimer timer_;
  std::unique_ptr<::ros::AsyncSpinner> spinner_;
  std::mutex mutex_;
  Steady::time_point last_drive_;
};

ros::RosSettings patient() {
  ros::RosSettings settings;
  settings.lost_s = 4.0;
  settings.focal_px = 203.0;
  settings.baseline_m = 0.12;
  return settings;
}

/// Commands 0.3 m/s until the robot is told to stand. @returns why the gate holds it
std::string drive_until_held(ros::RosRobot& robot, FakeRobot& fake) {
  Senses senses;
  until(robot, senses, 3.0, [&] {
    robot.send({0.3, 0.0, 0.0, 0.0});
    return !robot.hold().empty() && fake.forward_m_s == 0.0;
  });
  return robot.hold();
}

void drive_freely(ros::RosRobot& robot, FakeRobot& fake) {
  Senses senses;
  until(robot, senses, 10.0, [&] {
    robot.send({0.3, 0.0, 0.0, 0.0});
    return robot.hold().empty() && fake.forward_m_s == 0.3;
  });
  ASSERT_EQ(robot.hold(), "");
  ASSERT_EQ(fake.forward_m_s, 0.3);
}

// Both limits below: the deadline itself, one period of 50 ms, and a loaded machine.
TEST_F(ThroughRos, ARobotWithoutImagesIsToldToStandHoweverItIsCommanded) {
  FakeRobot fake;
  ros::RosRobot robot(patient(), {}, 20s);
  drive_freely(robot, fake);
  const auto blind = Steady::now();
  fake.has_eyes = false;
  EXPECT_EQ(drive_until_held(robot, fake), "no images");
  RecordProperty("seconds_to_zero", std::to_string(fake.drove_for_s(blind)));
  EXPECT_LT(fake.drove_for_s(blind), 0.5 + 0.3);

  fake.has_eyes = true;
  drive_freely(robot, fake);
  const auto late = Steady::now();
  fake.odometry_late_s = 0.8;
  EXPECT_THAT(drive_until_held(robot, fake), testing::StartsWith("odometry is"));
  EXPECT_LT(fake.drove_for_s(late), 0.3);
}

TEST_F(ThroughRos, ARobotThatDoesNotFollowItsCommandsHoldsUntilReset) {
  FakeRobot fake;
  ros::RosRobot robot(patient(), {}, 20s);
  fake.is_deaf = true;
  EXPECT_THAT(drive_until_held(robot, fake), testing::HasSubstr("does not follow"));
  fake.is_deaf = false;
  Senses senses;
  until(robot, senses, 1.0, [&] {
    robot.send({0.3, 0.0, 0.0, 0.0});
    EXPECT_EQ(fake.forward_m_s, 0.0);
    return false;
  });
  EXPECT_TRUE(robot.waits_for_reset());
  robot.reset();
  drive_freely(robot, fake);
}

TEST_F(ThroughRos, AMindThatHangsInTheMidstOfMotionHoldsUntilReset) {
  FakeRobot fake;
  ros::RosRobot robot(patient(), {}, 20s);
  drive_freely(robot, fake);
  std::this_thread::sleep_for(1200ms);
  Senses senses;
  until(robot, senses, 1.0, [&] {
    robot.send({0.3, 0.0, 0.0, 0.0});
    EXPECT_EQ(fake.forward_m_s, 0.0);
    return false;
  });
  EXPECT_EQ(robot.hold(), "the program stood still");
  robot.reset();
  drive_freely(robot, fake);
}

TEST_F(ThroughRos, TheEndOfTheMissionIsAZeroOnCmdVel) {
  FakeRobot fake;
  {
    ros::RosRobot robot(patient(), {}, 20s);
    drive_freely(robot, fake);
  }
  EXPECT_EQ(fake.forward_m_s, 0.0);
}

TEST_F(ThroughRos, ADeadMasterStopsTheRobotThoughItsLinksLive) {
  FakeRobot fake;
  ros::RosRobot robot(patient(), {}, 20s);
  drive_freely(robot, fake);
  const auto dead = Steady::now();
  master->kill();
  EXPECT_EQ(drive_until_held(robot, fake), "the ROS master is gone");
  RecordProperty("seconds_to_zero", std::to_string(fake.drove_for_s(dead)));
  EXPECT_LT(fake.drove_for_s(dead), 1.0 + 0.5);
  Senses senses;
  EXPECT_THROW(until(robot, senses, 10.0, [] { return false; }), std::runtime_error);
  master->start();
  ASSERT_TRUE(master->answers());
}

TEST_F(ThroughRos, CmdVelTowardsABoxStandsBeforeIt) {
  const auto server =
      serve(folder->write("box.yaml",
                          "striate_world: 1\n"
                          "name: box\n"
                          "corridor: {length: 12 m, width: 2.4 m, height: 2.7 m}\n"
                          "lights:\n"
                          "  - {from: 0 m, to: 12 m, every: 3 m}\n"
                          "obstacles:\n"
                          "  - {kind: cardboard_box, at: [6 m, 0 m], size: [0.4 m, 1.0 m, 0.8 m]}\n"
                          "start: {at: [4 m, 0 m], heading: 0 deg}\n"
                          "goal: {beyond: 10 m}\n"));
  ros::RosRobot robot(settings(), {}, 30s);
  Senses senses;
  bool moved = false;
  until(robot, senses, 20.0, [&] {
    robot.send({0.4, 0.0, 0.0, -0.2});
    moved = moved || senses.odometry.forward_m_s > 0.2;
    return moved && stands(senses);
  });
  EXPECT_TRUE(stands(senses));
  EXPECT_EQ(robot.hold(), "") << "the command is fresh: it is the robot's limiter that holds";
  // The box begins 1.8 m from the axle, the robot ends 0.21 m before it.
  EXPECT_GT(senses.odometry.pose.x_m, 0.8) << text_of(log("serve"));
  EXPECT_LT(senses.odometry.pose.x_m, 1.8 - 0.21 - 0.02);
}

}  // namespace
}  // namespace striate::scenarios
