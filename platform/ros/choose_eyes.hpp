#pragma once

#include <map>
#include <string>

#include "striate/platform/ros/ros_settings.hpp"

/// Which topics of a bag are the two eyes.
namespace striate::ros {

/// Topic and ROS type of everything that a bag holds.
using BagTopics = std::map<std::string, std::string>;

/// Bags hold full names.
[[nodiscard]] std::string full(const std::string& topic);

/// Two topics of one camera, by their names.
struct EyeTopics {
  std::string left;
  std::string right;
  std::string camera;  ///< the names' beginning up to the eye: "/stereo_a/"
};

[[nodiscard]] bool begins_with(const std::string& text, const std::string& beginning);

/// The eyes that are asked for, or the only ones; empty where there are none.
[[nodiscard]] EyeTopics choose_eyes(const BagTopics& topics, const RosSettings& s,
                                    const std::string& camera);

/// The wanted topic, or the first one of this type whose name has `part` in it.
[[nodiscard]] std::string find(const BagTopics& topics, const std::string& wanted,
                               const std::string& type, const std::string& part);

}  // namespace striate::ros
