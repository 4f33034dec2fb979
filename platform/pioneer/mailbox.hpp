#pragma once

#include <mutex>
#include <utility>

namespace striate::pioneer {

/// One slot between two threads: the newest value replaces an older one that nobody has read, and
/// neither side waits for the other longer than a copy takes.
template <class T>
class Mailbox {
 public:
  void put(T value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
  }
  [[nodiscard]] T newest() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }

 private:
  mutable std::mutex mutex_;
  T value_{};
};

}  // namespace striate::pioneer
