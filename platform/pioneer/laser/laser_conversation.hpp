#pragma once

#include <utility>

#include "striate/base/bytes.hpp"
#include "striate/platform/interface/senses.hpp"
#include "striate/platform/pioneer/laser/laser_settings.hpp"

namespace striate::pioneer {

/// What a driver keeps of its talk with a laser of either kind: what waits for its reply, the
/// newest scan, and when to begin anew.
/// @tparam Step what has been said; has at least begin, scan and closed.
template <class Step>
class LaserConversation {
 public:
  explicit LaserConversation(const LaserSettings& settings) : settings_(settings) {}

  [[nodiscard]] const LaserSettings& settings() const { return settings_; }
  [[nodiscard]] Step step() const { return step_; }
  [[nodiscard]] std::uint64_t set_ups() const { return set_ups_; }
  [[nodiscard]] TimePoint said_at() const { return said_at_; }

  void say(ByteView bytes, Step step, TimePoint now) {
    append(output_, bytes);
    step_ = step;
    said_at_ = now;
  }
  [[nodiscard]] Bytes take_output() { return std::exchange(output_, {}); }

  /// From now on scans come.
  void expect_scans(TimePoint now) {
    step_ = Step::scan;
    scanned_at_ = now;
  }
  /// An empty scan to fill, measured at `stamp`, heard at `now`. One that comes too late does not
  /// count as a sign of life: set-up, which measures the line anew, is begun again.
  RangeScan& begin_scan(TimePoint stamp, TimePoint now) {
    if (now - stamp <= from_seconds(settings_.stale_after_s)) scanned_at_ = now;
    scan_.stamp = stamp;
    scan_.readings.clear();
    return scan_;
  }
  /// The newest scan; empty when it is stale.
  [[nodiscard]] RangeScan scan(TimePoint now) const {
    if (now - scan_.stamp > from_seconds(settings_.stale_after_s)) return {};
    return scan_;
  }

  /// Whether the set-up is to be begun: at first, without a reply, without a scan. Counts them.
  [[nodiscard]] bool begins(TimePoint now) {
    if (step_ == Step::closed) return false;
    const bool waits = step_ == Step::scan
                           ? now - scanned_at_ < from_seconds(settings_.begin_again_after_s)
                           : now - said_at_ < from_seconds(settings_.reply_patience_s);
    if (step_ != Step::begin && waits) return false;
    ++set_ups_;
    return true;
  }

 private:
  LaserSettings settings_;
  Bytes output_;
  Step step_ = Step::begin;
  TimePoint said_at_;
  RangeScan scan_;
  TimePoint scanned_at_;
  std::uint64_t set_ups_ = 0;
};

}  // namespace striate::pioneer
