#include "striate/platform/rosbridge/operations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "striate/base/user_error.hpp"
#include "striate/platform/rosbridge/check_settings.hpp"

namespace striate::rosbridge {
namespace {

using nlohmann::json;
using testing::HasSubstr;

template <class Call>
std::string user_error_of(const Call& call) {
  try {
    call();
  } catch (const UserError& error) {
    return error.what();
  }
  return "none";
}

TEST(RosbridgeOperations, AllTopicsAreAskedForWithTheTypesOfTheirRos) {
  BridgeSettings settings;
  settings.topics.scan = "/scan";
  std::vector<std::string> types;
  for (const std::string& said : greetings(settings, true)) {
    types.push_back(json::parse(said).at("type"));
  }
  EXPECT_THAT(types,
              testing::ElementsAre("geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry",
                                   "sensor_msgs/msg/CompressedImage",
                                   "sensor_msgs/msg/CompressedImage", "sensor_msgs/msg/CameraInfo",
                                   "sensor_msgs/msg/CameraInfo", "sensor_msgs/msg/LaserScan"));
  settings.ros = RosVersion::one;
  settings.topics.left_image = "/left/image";
  settings.topics.scan.clear();
  const std::vector<std::string> one = greetings(settings, true);
  EXPECT_EQ(one.size(), 6u) << "no laser";
  EXPECT_EQ(json::parse(one[0]).at("type"), "geometry_msgs/Twist");
  EXPECT_EQ(json::parse(one[2]).at("type"), "sensor_msgs/Image");
  EXPECT_EQ(greetings(settings, false).size(), 2u) << "a camera of its own";
}

TEST(RosbridgeOperations, ATwistIsStampedWhereItIsAskedFor) {
  BridgeSettings settings;
  const MotorCommand command{.forward_m_s = 0.25, .turn_rad_s = -0.5};
  const json plain = json::parse(publish_twist(settings, command, 7));
  EXPECT_EQ(plain.at("op"), "publish");
  EXPECT_EQ(plain.at("topic"), "/cmd_vel");
  EXPECT_EQ(plain.at("msg").at("linear").at("x"), 0.25);
  EXPECT_EQ(plain.at("msg").at("angular").at("z"), -0.5);
  settings.stamped = true;
  const json stamped = json::parse(publish_twist(settings, command, 3'000'000'007)).at("msg");
  EXPECT_EQ(stamped.at("header").at("stamp"), (json{{"sec", 3}, {"nanosec", 7}}));
  EXPECT_EQ(stamped.at("header").at("frame_id"), "base_link");
  EXPECT_EQ(stamped.at("twist").at("linear").at("x"), 0.25);
  const json unknown = json::parse(publish_twist(settings, command, std::nullopt)).at("msg");
  EXPECT_FALSE(unknown.at("header").contains("stamp")) << "the server sets its own";
  settings.ros = RosVersion::one;
  const json one = json::parse(publish_twist(settings, command, 3'000'000'007)).at("msg");
  EXPECT_EQ(one.at("header").at("stamp"), (json{{"secs", 3}, {"nsecs", 7}}));
}

TEST(BridgeAddress, IsReadWithPortPathAndBrackets) {
  const BridgeAddress plain = read_bridge_address("ws://turtlebot");
  EXPECT_EQ(plain.host, "turtlebot");
  EXPECT_EQ(plain.port, 9090);
  EXPECT_EQ(plain.path, "/");
  const BridgeAddress long_one = read_bridge_address("ws://[::1]:80/bridge?token=1");
  EXPECT_EQ(long_one.host, "::1");
  EXPECT_EQ(long_one.port, 80);
  EXPECT_EQ(long_one.path, "/bridge?token=1");
  EXPECT_EQ(long_one.host_field(), "[::1]:80");
  EXPECT_EQ(read_bridge_address("ws://h?x=1").path, "/?x=1");
}

TEST(BridgeAddress, OneThatIsNoneIsToldWithWhatIsWrong) {
  const auto error_of = [](const char* url) {
    return user_error_of([url] { (void)read_bridge_address(url); });
  };
  EXPECT_THAT(error_of("wss://robot"), HasSubstr("ssh -L 9090"));
  EXPECT_THAT(error_of("http://robot"), HasSubstr("must begin with ws://"));
  EXPECT_THAT(error_of("ws://"), HasSubstr("the host is missing"));
  EXPECT_THAT(error_of("ws://robot:0"), HasSubstr("1 .. 65535"));
  EXPECT_THAT(error_of("ws://robot:90 90"), HasSubstr("letters that no address has"));
  EXPECT_THAT(error_of("ws://me@robot"), HasSubstr("names no user"));
  EXPECT_THAT(error_of("ws://[::1"), HasSubstr("']' is missing"));
  EXPECT_THAT(error_of("ws://[::1]9"), HasSubstr("only a port"));
}

TEST(BridgeSettings, TopicsThatCannotBeAreToldByTheirKeys) {
  BridgeSettings settings;
  settings.url = "ws://robot";
  EXPECT_EQ(check_settings(settings).host, "robot");
  settings.topics.odometry = "odom etry";
  EXPECT_THAT(user_error_of([&] { check_settings(settings); }),
              HasSubstr("rosbridge.topics.odometry 'odom etry'"));
  settings.topics.odometry = settings.topics.left_info;
  EXPECT_THAT(user_error_of([&] { check_settings(settings); }),
              HasSubstr("topics.left_info and rosbridge.topics.odometry are both"));
  settings.topics.odometry.clear();
  EXPECT_THAT(user_error_of([&] { check_settings(settings); }), HasSubstr("topics.odometry"));
}

}  // namespace
}  // namespace striate::rosbridge
