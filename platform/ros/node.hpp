#pragma once

#include <string>

namespace striate::ros {

/// Joins this process to the ROS graph; the first call counts, a process is one node. Signals and
/// their handling stay the program's.
/// @param name of the node; ROS makes it unique
/// @throws UserError for a ROS_MASTER_URI that is none, std::runtime_error where no master answers.
void join_ros(const std::string& name);

}  // namespace striate::ros
