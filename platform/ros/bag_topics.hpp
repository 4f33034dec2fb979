#pragma once

#include <string>

#include "striate/platform/ros/choose_eyes.hpp"
#include "striate/platform/ros/ros_settings.hpp"

namespace striate::ros {

/// The settings with each topic that the bag does not have replaced by one that it has, of the
/// right type. The two eyes are looked for together: two topics whose names differ in "left" and
/// "right" alone, and the CameraInfo beside them; rectified images go before raw ones. Where there
/// is none, the name stays.
/// @param camera what the eyes' topics begin with, for bags with several stereo cameras; "": the
/// only one. @throws UserError where there are several to choose from, or none that begins so; it
/// lists them.
[[nodiscard]] RosSettings find_topics(const BagTopics& topics, RosSettings settings,
                                      const std::string& camera = {});

/// "  /odom: nav_msgs/Odometry" line by line.
[[nodiscard]] std::string list_of(const BagTopics& topics);

}  // namespace striate::ros
