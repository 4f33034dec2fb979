#pragma once

#include <string>

#include "striate/platform/remote/inbox.hpp"

namespace striate::remote {

/// Why a robot whose senses come through ROS must stand; "" where nothing is stale. Images and
/// odometry count, and a laser that has spoken: each by its arrival, for a sender that is silent,
/// and by its stamp, for messages that pile up on the way.
[[nodiscard]] std::string stale_sense(const Inbox& inbox, Duration stale, TimePoint now);

}  // namespace striate::remote
