#include "tests/reference/temporary_folder.hpp"
#include "tests/scenarios/refused.hpp"

namespace striate::scenarios {
namespace {

TEST(RosbridgeCommand, RobotsThatCannotBeAreRefusedBeforeAnythingIsConnected) {
  const reference::TemporaryFolder folder;
  auto robot = [&folder, files = 0](const std::string& yaml) mutable {
    const std::string name = "robot" + std::to_string(files++) + ".yaml";
    return Words{"run", "config/tasks/corridor.yaml", "--robot", folder.write(name, yaml)};
  };
  expect_refused({
      {robot("rosbridge: {url: http://robot:9090}"), "rosbridge.url 'http://robot:9090'"},
      {robot("rosbridge: {url: wss://robot}"), "let a tunnel encrypt it"},
      {robot("rosbridge: {url: ws://robot, topics: {odometry: /cmd_vel}}"),
       "rosbridge.topics.odometry and rosbridge.topics.cmd_vel are both '/cmd_vel'"},
      {robot("rosbridge: {url: ws://robot, ros: 3}"), "'3' is not known as 'ros'"},
      {robot("rosbridge: {url: ws://robot, topics: {odometrie: /odom}}"), "odometry"},
      {robot("rosbridge: {url: ws://robot}\npioneer: {devices: {base: tcp://localhost:8101}}"),
       "names two robots"},
  });
}

TEST(RosbridgeCommand, TheShippedRobotIsListedWithItsTopics) {
  const Ended ended = striate_here({"config", "--robot", "config/robots/turtlebot_rosbridge.yaml"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::HasSubstr("rosbridge.topics.cmd_vel"));
  EXPECT_THAT(ended.out, testing::HasSubstr("ws://localhost:9090"));
}

}  // namespace
}  // namespace striate::scenarios
