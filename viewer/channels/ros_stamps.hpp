#pragma once

#include <cmath>
#include <string>

#include "striate/base/geometry.hpp"
#include "striate/base/time.hpp"
#include "striate/viewer/messages/common_messages.hpp"

/// Times, headers and poses of ours in messages of ROS.
namespace striate::viewer {

/// Of the mission's clock, which begins at zero with the body. Nanoseconds are never negative.
[[nodiscard]] inline msgs::Time ros_time(TimePoint stamp) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  const std::int64_t ns = stamp.time_since_epoch().count();
  const std::int64_t rest = (ns % kSecond_ns + kSecond_ns) % kSecond_ns;
  return {static_cast<std::int32_t>((ns - rest) / kSecond_ns), static_cast<std::uint32_t>(rest)};
}

[[nodiscard]] inline msgs::Header ros_header(TimePoint stamp, const char* frame) {
  return {ros_time(stamp), frame};
}

[[nodiscard]] inline msgs::Quaternion ros_heading(double heading_rad) {
  return {0.0, 0.0, std::sin(heading_rad / 2.0), std::cos(heading_rad / 2.0)};
}

[[nodiscard]] inline msgs::Pose ros_pose(const Pose2& pose) {
  return {{pose.x_m, pose.y_m, 0.0}, ros_heading(pose.heading_rad)};
}

}  // namespace striate::viewer
