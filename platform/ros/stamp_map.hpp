#pragma once

#include <cstdint>

#include "platform/interface/time.hpp"

namespace striate::ros1 {

/// Brings stamps of another machine's clock, which may be wrong, set or stopped, to our steady one.
/// The message that was least under way tells how the clocks lie to each other; every other is
/// older than its arrival by what it was later than that one. So a stamp is never in the future,
/// and messages keep their distances in time.
class StampMap {
 public:
  /// @param stamp_ns of the message; 0 where the sender gives none: then the arrival counts
  TimePoint to_body(std::int64_t stamp_ns, TimePoint arrived) {
    if (stamp_ns == 0) return arrived;
    const Duration offset = arrived.time_since_epoch() - Duration(stamp_ns);
    const bool jumped = offset - offset_ > kJump || offset_ - offset > kJump;
    if (!known_ || jumped) {
      offset_ = offset;
      known_ = true;
    } else {
      // Clocks drift apart: the offset may grow by a thousandth of the time that passes.
      offset_ += (arrived - last_) / 1000;
      if (offset < offset_) offset_ = offset;
    }
    last_ = arrived;
    return TimePoint(Duration(stamp_ns) + offset_);
  }

 private:
  /// A source that begins anew, or whose clock was set.
  static constexpr Duration kJump = std::chrono::seconds(2);
  Duration offset_{};
  TimePoint last_;
  bool known_ = false;
};

}  // namespace striate::ros1
