#pragma once

#include <map>
#include <string>

#include "striate/platform/ros/ros_settings.hpp"

namespace striate::ros {

/// Topic and ROS type of everything that a bag holds.
using BagTopics = std::map<std::string, std::string>;

/// The settings with each topic that the bag does not have replaced by one that it has, of the
/// right type and, for eyes, with "left" or "right" in its name; rectified images go before raw
/// ones. Where there is none, the name stays.
[[nodiscard]] RosSettings find_topics(const BagTopics& topics, RosSettings settings);

/// "  /odom: nav_msgs/Odometry" line by line.
[[nodiscard]] std::string list_of(const BagTopics& topics);

}  // namespace striate::ros
