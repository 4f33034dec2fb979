#include "striate/platform/rosbridge/rosbridge_robot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <thread>

#include "striate/base/user_error.hpp"
#include "tests/unit/rosbridge/bridge_server.hpp"
#include "tests/unit/rosbridge/robot_messages.hpp"

namespace striate::rosbridge {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// Longer than anything here takes on a busy machine.
constexpr auto kPatience = 10s;

bool soon(const std::function<bool()>& wanted) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < end) {
    if (wanted()) return true;
    std::this_thread::sleep_for(10ms);
  }
  return wanted();
}

BridgeSettings settings_for(const std::string& url) {
  BridgeSettings settings;
  settings.url = url;
  settings.topics.left_image = "/left/image";
  settings.topics.right_image = "/right/image";
  settings.topics.left_info = "/left/info";
  settings.topics.right_info = "/right/info";
  settings.lost_s = 2.0;
  return settings;
}

/// A robot that says what it feels twenty times a second, and obeys at once.
class Talker {
 public:
  explicit Talker(BridgeServer& server) : server_(server), thread_([this] { talk(); }) {}
  ~Talker() {
    ends_ = true;
    thread_.join();
  }
  Talker(const Talker&) = delete;
  Talker& operator=(const Talker&) = delete;
  std::atomic<bool> sees{true};
  std::atomic<bool> feels{true};

 private:
  void talk() {
    while (!ends_) {
      const auto since = std::chrono::system_clock::now().time_since_epoch();
      const std::int64_t now_ns = std::chrono::nanoseconds(since).count();
      const std::vector<double> speeds_m_s = server_.speeds_m_s();
      if (feels) {
        server_.publish("/odom", odometry_message(true, now_ns, 1.0,
                                                  speeds_m_s.empty() ? 0.0 : speeds_m_s.back()));
      }
      server_.publish("/left/info", camera_message(true, 0.0));
      server_.publish("/right/info", camera_message(true, 0.12));
      if (sees) {
        server_.publish("/left/image", image_message(true, now_ns));
        server_.publish("/right/image", image_message(true, now_ns));
      }
      std::this_thread::sleep_for(50ms);
    }
  }
  BridgeServer& server_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

/// Decides each cycle to go on, as a mission does, until something is so.
bool drive_until(RosbridgeRobot& robot, const std::function<bool()>& wanted) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  Senses senses;
  while (std::chrono::steady_clock::now() < end) {
    robot.sense(senses);
    robot.send({.forward_m_s = 0.2});
    if (wanted()) return true;
  }
  return false;
}

TEST(RosbridgeRobot, IsFeltAndDrivenAndLeftWithAZero) {
  BridgeServer server;
  Talker talker(server);
  {
    RosbridgeRobot robot(settings_for(server.url()));
    Senses senses;
    ASSERT_TRUE(robot.sense(senses));
    EXPECT_EQ(senses.odometry.pose.x_m, 0.0) << "the first pose is the origin";
    EXPECT_EQ(senses.stereo.left.size(), cv::Size(64, 48));
    EXPECT_NEAR(senses.stereo.baseline_m, 0.12, 1e-9);
    EXPECT_NEAR(senses.stereo.focal_px, 60.0, 1e-9);
    EXPECT_TRUE(server.speeds_m_s().empty()) << "nothing is said before the first command";
    EXPECT_TRUE(drive_until(robot, [&] {
      const std::vector<double> speeds_m_s = server.speeds_m_s();
      return !speeds_m_s.empty() && speeds_m_s.back() == 0.2;
    })) << robot.hold();
    EXPECT_EQ(robot.hold(), "");
  }
  EXPECT_TRUE(soon([&] { return server.heard().back().at("op") == "unadvertise"; }));
  EXPECT_EQ(server.speeds_m_s().back(), 0.0);
}

TEST(RosbridgeRobot, StandsWhileImagesAreSilentAndIsLostAfterALongerTime) {
  BridgeServer server;
  Talker talker(server);
  std::optional<RosbridgeRobot> robot(std::in_place, settings_for(server.url()));
  const auto drives = [&] {
    const std::vector<double> speeds_m_s = server.speeds_m_s();
    return !speeds_m_s.empty() && speeds_m_s.back() == 0.2;
  };
  ASSERT_TRUE(drive_until(*robot, drives)) << robot->hold();
  talker.sees = false;
  ASSERT_TRUE(drive_until(*robot, [&] { return server.speeds_m_s().back() == 0.0; }));
  // The last of them is old by its stamp a moment before its arrival is long ago.
  EXPECT_TRUE(drive_until(*robot, [&] { return robot->hold() == "no images"; })) << robot->hold();
  std::string why;
  try {
    drive_until(*robot, [] { return false; });
  } catch (const std::runtime_error& error) {
    why = error.what();
  }
  EXPECT_THAT(why, HasSubstr("the robot is lost: no images on /left/image"));
  robot.reset();
  EXPECT_TRUE(soon([&] { return server.heard().back().at("op") == "unadvertise"; }));
  EXPECT_EQ(server.speeds_m_s().back(), 0.0);
}

TEST(RosbridgeRobot, AfterALineThatBrokeItHoldsUntilItIsReset) {
  auto server = std::make_unique<BridgeServer>();
  const std::uint16_t port = server->port();
  auto talker = std::make_unique<Talker>(*server);
  BridgeSettings settings = settings_for(server->url());
  settings.lost_s = 8.0;
  RosbridgeRobot robot(settings);
  const auto drives = [&] {
    const std::vector<double> speeds_m_s = server->speeds_m_s();
    return !speeds_m_s.empty() && speeds_m_s.back() == 0.2;
  };
  ASSERT_TRUE(drive_until(robot, drives)) << robot.hold();
  talker.reset();
  server.reset();
  ASSERT_TRUE(drive_until(robot, [&] { return !robot.hold().empty(); }));
  EXPECT_THAT(robot.hold(), HasSubstr("no line to ws://127.0.0.1"));

  server = std::make_unique<BridgeServer>(port);
  talker = std::make_unique<Talker>(*server);
  ASSERT_TRUE(drive_until(robot, [&] { return server->speeds_m_s().size() > 10; }));
  for (const double speed_m_s : server->speeds_m_s()) EXPECT_EQ(speed_m_s, 0.0);
  EXPECT_EQ(robot.hold(), "the line to the robot broke");
  EXPECT_TRUE(robot.waits_for_reset());
  robot.reset();
  EXPECT_TRUE(drive_until(robot, drives)) << robot.hold();
}

TEST(RosbridgeRobot, AServerThatDoesNotAnswerIsNamedThoughItsLineIsOpen) {
  BridgeServer server;
  Talker talker(server);
  BridgeSettings settings = settings_for(server.url());
  settings.lost_s = 20.0;
  RosbridgeRobot robot(settings);
  server.stall(2s);
  EXPECT_TRUE(drive_until(robot, [&] { return robot.hold() == server.url() + " does not answer"; }))
      << robot.hold();
}

TEST(RosbridgeRobot, ACameraOfThisMachineIsSeenInPlaceOfTopics) {
  BridgeServer server;
  Talker talker(server);
  const MakeCamera camera = [](const Clock& clock) {
    return OwnCamera{.newest =
                         [&clock] {
                           StereoFrame frame;
                           frame.stamp = clock.now();
                           frame.left = frame.right = cv::Mat3b(24, 32, cv::Vec3b(1, 2, 3));
                           frame.focal_px = 30.0;
                           frame.centre_u_px = 15.5;
                           frame.centre_v_px = 11.5;
                           frame.baseline_m = 0.1;
                           return frame;
                         },
                     .trouble = [] { return std::string(); }};
  };
  RosbridgeRobot robot(settings_for(server.url()), {}, camera);
  Senses senses;
  ASSERT_TRUE(robot.sense(senses));
  EXPECT_EQ(senses.stereo.left.size(), cv::Size(32, 24));
  for (const nlohmann::json& one : server.heard()) EXPECT_NE(one.at("topic"), "/left/image");
}

TEST(RosbridgeRobot, WhatIsMissingIsToldBeforeAnythingMoves) {
  const auto why = [](const BridgeSettings& settings) -> std::string {
    try {
      const RosbridgeRobot robot(settings, {}, {}, 500ms);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  BridgeServer server;
  EXPECT_THAT(why(settings_for(server.url())), HasSubstr("no odometry came on /odom from ws://"));
  std::uint16_t free_port = 0;
  {
    const BridgeServer gone;
    free_port = gone.port();
  }
  EXPECT_THAT(why(settings_for("ws://127.0.0.1:" + std::to_string(free_port))),
              HasSubstr("Connection refused"));
  EXPECT_THAT(why(settings_for("ws://no.such.host.invalid")), HasSubstr("is not known"));
  EXPECT_THAT(why(settings_for("tcp://robot")), HasSubstr("must begin with ws://"));
}

TEST(RosbridgeRobot, AMessageThatIsTooLargeEndsTheLineAndIsNamed) {
  BridgeServer server;
  BridgeSettings settings = settings_for(server.url());
  settings.most_message_mb = 1;
  std::string why;
  std::thread floods([&server] {
    soon([&server] { return server.heard().size() > 5; });
    server.say("/odom", std::string(1'100'000, ' '));
  });
  try {
    const RosbridgeRobot robot(settings, {}, {}, 700ms);
  } catch (const std::runtime_error& error) {
    why = error.what();
  }
  floods.join();
  EXPECT_THAT(why, HasSubstr("larger than rosbridge.most_message"));
}

}  // namespace
}  // namespace striate::rosbridge
