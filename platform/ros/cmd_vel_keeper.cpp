#include "striate/platform/ros/cmd_vel_keeper.hpp"

#include <geometry_msgs/Twist.h>
#include <ros/init.h>
#include <ros/node_handle.h>

#include "striate/platform/ros/node.hpp"

namespace striate::ros {
namespace {

/// A node that ends tells the master so; over a network it may take this long (by hand)
constexpr auto kNodeEnds = std::chrono::milliseconds(1000);

struct ZeroPublisher {
  ::ros::NodeHandle node;
  ::ros::Publisher cmd_vel;
};

remote::KeeperVoice publisher_of_zeros(const std::string& topic) {
  join_ros("striate_keeper");
  auto zeros = std::make_shared<ZeroPublisher>();
  zeros->cmd_vel = zeros->node.advertise<geometry_msgs::Twist>(topic, 1);
  return {[zeros] { zeros->cmd_vel.publish(geometry_msgs::Twist()); },
          [](bool /*died*/) { ::ros::shutdown(); }};
}

}  // namespace

std::unique_ptr<remote::ZeroKeeper> make_cmd_vel_keeper(const std::string& topic) {
  if (::ros::isInitialized()) return std::make_unique<remote::ZeroKeeper>();
  return std::make_unique<remote::ZeroKeeper>(
      "cmd_vel-keeper", [&topic] { return publisher_of_zeros(topic); }, kNodeEnds);
}

}  // namespace striate::ros
