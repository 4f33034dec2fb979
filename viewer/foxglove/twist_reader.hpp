#pragma once

#include "striate/base/bytes.hpp"
#include "striate/viewer/foxglove/protocol.hpp"

namespace striate::viewer::foxglove {

/// How fast somebody wants the robot to go.
struct WantedMotion {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;  ///< counter-clockwise
};

/// Whether messages of the channel can be read: geometry_msgs Twist or TwistStamped, cdr or json.
[[nodiscard]] bool is_twist(const ClientChannel& channel);

/// @throws BadBytes for what is no such message
[[nodiscard]] WantedMotion read_twist(const ClientChannel& channel, ByteView payload);

}  // namespace striate::viewer::foxglove
