#pragma once

#include <memory>
#include <string>

#include "striate/platform/remote/zero_keeper.hpp"

namespace striate::ros {

/// A keeper that is a ROS node of its own, which says zero on `cmd_vel`. To be made before this
/// program joins ROS, since a node cannot be shared; none where it has joined already.
[[nodiscard]] std::unique_ptr<remote::ZeroKeeper> make_cmd_vel_keeper(const std::string& topic);

}  // namespace striate::ros
