#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <vector>

#include "striate/base/steady_clock.hpp"
#include "striate/platform/ros/inbox.hpp"

namespace striate::ros {

/// An inbox that ROS's threads fill.
struct Mailbox {
  explicit Mailbox(const RosSettings& settings) : inbox(settings) {}
  SteadyClock clock;
  mutable std::mutex mutex;  ///< guards the inbox
  Inbox inbox;
};

/// Subscribes to all that a body is felt by. What comes goes to the mailbox, which must live as
/// long as the node's queue is served.
[[nodiscard]] std::vector<::ros::Subscriber> subscribe(::ros::NodeHandle& node,
                                                       const RosSettings& settings,
                                                       Mailbox& mailbox);

}  // namespace striate::ros
