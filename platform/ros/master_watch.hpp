#pragma once

#include <memory>

#include "striate/base/time.hpp"

namespace striate::ros {

/// Asks the ROS master four times a second whether it is there, in a thread of its own and with a
/// deadline: roscpp's own question has none. Links between nodes outlive the master, but nobody
/// could join any more, no one with a stop button either.
class MasterWatch {
 public:
  /// The master that this process has joined, see join_ros(). Counts as heard at the beginning.
  MasterWatch();
  ~MasterWatch();
  /// Time since it last answered.
  [[nodiscard]] Duration silent_for() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::ros
