#pragma once

#include <sys/types.h>

#include <string>

namespace striate::ros {

/// A process and a ROS node of its own that says zero on `cmd_vel` when this program dies of
/// anything, or is silent for longer than it may be while the robot moves: many robots drive on
/// with the last command that they were given.
class CmdVelKeeper {
 public:
  /// Before this program joins ROS, since a node cannot be shared. Nothing where it has joined
  /// already, or where no process can be had: then the robot's own deadline is what there is.
  explicit CmdVelKeeper(const std::string& topic);
  /// An end on purpose: nothing more is said.
  ~CmdVelKeeper();
  CmdVelKeeper(const CmdVelKeeper&) = delete;
  CmdVelKeeper& operator=(const CmdVelKeeper&) = delete;

  /// A sign of life, at least each 100 ms. @param moves what was published is no stand
  void hear(bool moves) noexcept;

 private:
  int line_ = -1;
  pid_t keeper_ = -1;
};

}  // namespace striate::ros
