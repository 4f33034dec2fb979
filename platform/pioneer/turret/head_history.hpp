#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "striate/platform/interface/senses.hpp"

namespace striate::pioneer {

/// Where the head has looked during the last second or so, so that an image that took a while to
/// come is given the pose of its own moment.
class HeadHistory {
 public:
  void add(TimePoint stamp, const HeadPose& pose) {
    if (size_ > 0 && stamp <= newest().stamp) return;
    entries_[next_] = {stamp, pose};
    next_ = (next_ + 1) % entries_.size();
    size_ = std::min(size_ + 1, entries_.size());
  }
  /// Between two readings in proportion; before the oldest and after the newest these.
  [[nodiscard]] HeadPose at(TimePoint stamp) const {
    if (size_ == 0) return {};
    Entry later = newest();
    for (std::size_t back = 0; back < size_; ++back) {
      const Entry& entry = entries_[(next_ + entries_.size() - 1 - back) % entries_.size()];
      if (entry.stamp <= stamp) return between(entry, later, stamp);
      later = entry;
    }
    return later.pose;
  }

 private:
  struct Entry {
    TimePoint stamp;
    HeadPose pose;
  };
  [[nodiscard]] const Entry& newest() const {
    return entries_[(next_ + entries_.size() - 1) % entries_.size()];
  }
  static HeadPose between(const Entry& a, const Entry& b, TimePoint stamp) {
    if (b.stamp <= a.stamp || stamp >= b.stamp) return b.pose;
    const double t = to_seconds(stamp - a.stamp) / to_seconds(b.stamp - a.stamp);
    return {a.pose.pan_rad + t * (b.pose.pan_rad - a.pose.pan_rad),
            a.pose.tilt_rad + t * (b.pose.tilt_rad - a.pose.tilt_rad)};
  }

  std::array<Entry, 128> entries_{};
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

}  // namespace striate::pioneer
