#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>

namespace striate::remote {

/// How a keeper speaks to the robot, by a connection of its own; what may be left out is empty.
struct KeeperVoice {
  std::function<void()> say_zero;
  std::function<void(bool died)> end;  ///< the last that it says; died: not an end on purpose
};

/// A process of its own that says zero when this program dies of anything, or is silent for longer
/// than it may be while the robot moves: many robots drive on with the last command that they were
/// given.
class ZeroKeeper {
 public:
  /// None: then the robot's own deadline is what there is.
  ZeroKeeper() = default;
  /// @param name of the process, at most 15 characters
  /// @param make_voice is called in the keeper's process; what it throws ends that alone
  /// @param ends_within how long the end of this object waits for the keeper's
  ZeroKeeper(const char* name, const std::function<KeeperVoice()>& make_voice,
             std::chrono::milliseconds ends_within);
  /// An end on purpose: nothing more is said.
  ~ZeroKeeper();
  ZeroKeeper(const ZeroKeeper&) = delete;
  ZeroKeeper& operator=(const ZeroKeeper&) = delete;

  /// A sign of life, at least each 100 ms. @param moves what was published is no stand
  void hear(bool moves) noexcept;

 private:
  int line_ = -1;
  pid_t keeper_ = -1;
  std::chrono::milliseconds ends_within_{0};
};

}  // namespace striate::remote
