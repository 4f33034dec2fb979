#pragma once

#include <cstdint>

#include "striate/base/time.hpp"

namespace striate::ros {

/// Stamps of a body as ROS time. A simulated body that cannot keep up with real time would fall
/// behind for good; so where the two clocks are more than 50 ms apart they are put together anew.
class BodyToRosTime {
 public:
  /// Both clocks at the same moment.
  void tie(TimePoint body_now, std::int64_t ros_now_ns) {
    const Duration offset = Duration(ros_now_ns) - body_now.time_since_epoch();
    const Duration apart = offset > offset_ ? offset - offset_ : offset_ - offset;
    if (apart > std::chrono::milliseconds(50)) offset_ = offset;
  }
  [[nodiscard]] std::int64_t ros_ns(TimePoint stamp) const {
    const std::int64_t ns = (stamp.time_since_epoch() + offset_).count();
    return ns > 0 ? ns : 0;
  }

 private:
  Duration offset_{};
};

}  // namespace striate::ros
