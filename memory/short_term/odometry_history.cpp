#include "striate/memory/short_term/odometry_history.hpp"

#include <algorithm>

namespace striate::memory {

const OdometryHistory& OdometryHistory::add(TimePoint stamp, const Pose2& pose) {
  if (count_ > 0 && stamp <= back(0).stamp) return *this;
  entries_[next_] = {stamp, pose};
  next_ = (next_ + 1) % kCapacity;
  count_ = std::min(count_ + 1, kCapacity);
  return *this;
}

bool OdometryHistory::reaches(TimePoint stamp) const {
  return count_ > 0 && stamp >= back(count_ - 1).stamp;
}

Pose2 OdometryHistory::at(TimePoint stamp) const {
  if (count_ == 0) return {};
  if (stamp >= back(0).stamp) return back(0).pose;
  for (std::size_t steps = 1; steps < count_; ++steps) {
    const Entry& before = back(steps);
    if (stamp < before.stamp) continue;
    const Entry& after = back(steps - 1);
    const double t = to_seconds(stamp - before.stamp) / to_seconds(after.stamp - before.stamp);
    const double turned = wrap_angle(after.pose.heading_rad - before.pose.heading_rad);
    return {before.pose.x_m + t * (after.pose.x_m - before.pose.x_m),
            before.pose.y_m + t * (after.pose.y_m - before.pose.y_m),
            wrap_angle(before.pose.heading_rad + t * turned)};
  }
  return back(count_ - 1).pose;
}

}  // namespace striate::memory
