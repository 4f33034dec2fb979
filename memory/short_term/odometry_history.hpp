#pragma once

#include <array>
#include <cstddef>

#include "striate/platform/interface/senses.hpp"

namespace striate::memory {

/// Where the robot was, and what it looked at, over the last seconds: an image is up to some
/// hundred milliseconds old when it is understood, and belongs to the pose of its own moment.
class OdometryHistory {
 public:
  static constexpr std::size_t kCapacity = 64;  ///< by hand: 6.4 s of cycles

  /// @return this history, as it is now
  const OdometryHistory& add(TimePoint stamp, const Pose2& pose);
  /// Interpolated; the nearest kept pose where `stamp` lies outside what is kept.
  [[nodiscard]] Pose2 at(TimePoint stamp) const;
  /// Whether `stamp` is not older than what is kept.
  [[nodiscard]] bool reaches(TimePoint stamp) const;

 private:
  struct Entry {
    TimePoint stamp;
    Pose2 pose;
  };
  [[nodiscard]] const Entry& back(std::size_t steps) const {
    return entries_[(next_ + kCapacity - 1 - steps) % kCapacity];
  }
  std::array<Entry, kCapacity> entries_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace striate::memory
