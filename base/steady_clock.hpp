#pragma once

#include <ctime>

#include "striate/base/time.hpp"

namespace striate {

/// Real time since it was made; never jumps, and runs on while the machine is suspended: what was
/// young before it slept is old when it wakes.
class SteadyClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return TimePoint(since_boot() - began_); }
  /// Of the machine, its sleep included.
  [[nodiscard]] static Duration since_boot() {
    std::timespec time{};
    clock_gettime(CLOCK_BOOTTIME, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }

 private:
  Duration began_ = since_boot();
};

}  // namespace striate
