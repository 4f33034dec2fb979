#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "striate/base/time.hpp"

namespace striate::remote {

/// Topics that tell how the clocks lie; each of one publisher, so that its stamps only grow.
enum class Stream : std::uint8_t { left, right, odometry, laser, sonar, count };

/// Brings stamps of another machine's clock, which may be wrong, set or stopped, to our steady one.
/// The message that was least under way tells how the clocks lie to each other; every other is
/// older than its arrival by what it was later than that one. So a stamp is never in the future,
/// messages keep their distances in time, and a link on which they pile up makes them old. All
/// topics are to be stamped by one clock: those that lag behind it look late.
class StampMap {
 public:
  /// Each message once, in the order of arrival; without a stamp (0) it tells nothing.
  void learn(Stream stream, std::int64_t stamp_ns, TimePoint arrived) {
    if (stamp_ns == 0) return;
    const Duration offset = arrived.time_since_epoch() - Duration(stamp_ns);
    std::int64_t& newest_ns = newest_ns_[static_cast<std::size_t>(stream)];
    // A topic keeps its order. Where its stamps go back, the sender's clock was set, or it began
    // anew; mere lateness, however long, is no reason to believe that a message is fresh.
    if (newest_ns != 0 && newest_ns - stamp_ns > kBack.count()) {
      newest_ns_.fill(0);
      known_ = false;
    }
    newest_ns = newest_ns > stamp_ns ? newest_ns : stamp_ns;
    if (known_) offset_ += (arrived - last_) / kDriftShare;
    if (!known_ || offset < offset_) offset_ = offset;
    known_ = true;
    last_ = arrived;
  }
  /// @param stamp_ns of a message; 0 where the sender gave none. Then, and while nothing has been
  /// learned, the arrival counts.
  [[nodiscard]] TimePoint to_body(std::int64_t stamp_ns, TimePoint arrived) const {
    return stamp_ns == 0 || !known_ ? arrived : TimePoint(Duration(stamp_ns) + offset_);
  }
  /// The sender's clock at a moment of ours, late by what the quickest message took; nothing while
  /// no stamp has come.
  [[nodiscard]] std::optional<std::int64_t> to_sender(TimePoint ours) const {
    if (!known_) return std::nullopt;
    return (ours.time_since_epoch() - offset_).count();
  }

 private:
  /// Stamps of one topic that go back by more: the clock was set; less is disorder (ours)
  static constexpr Duration kBack = std::chrono::milliseconds(100);
  /// Clocks drift apart: the offset may grow by this share of the time that passes (200 ppm).
  static constexpr int kDriftShare = 5000;
  std::array<std::int64_t, static_cast<std::size_t>(Stream::count)> newest_ns_{};
  Duration offset_{};
  TimePoint last_;
  bool known_ = false;
};

}  // namespace striate::remote
