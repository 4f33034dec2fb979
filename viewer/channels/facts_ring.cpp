#include "striate/viewer/channels/facts_ring.hpp"

namespace striate::viewer {

bool FactsRing::put(const std::function<void(CycleFacts&)>& fill) {
  {
    const std::lock_guard lock(mutex_);
    if (filled_ - emptied_ == slots_.size()) {
      ++lost_;
      return false;
    }
  }
  // The slot is this side's until it is counted as filled.
  fill(slots_[filled_ % slots_.size()]);
  {
    const std::lock_guard lock(mutex_);
    ++filled_;
  }
  wake_.notify_one();
  return true;
}

void FactsRing::end() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_one();
}

const CycleFacts* FactsRing::front() const {
  const std::lock_guard lock(mutex_);
  return emptied_ < filled_ ? &slots_[emptied_ % slots_.size()] : nullptr;
}

const CycleFacts* FactsRing::wait_for_front() {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return ended_ || emptied_ < filled_; });
  return emptied_ < filled_ ? &slots_[emptied_ % slots_.size()] : nullptr;
}

void FactsRing::pop() {
  const std::lock_guard lock(mutex_);
  ++emptied_;
}

std::size_t FactsRing::waiting() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(filled_ - emptied_);
}

std::uint64_t FactsRing::filled() const {
  const std::lock_guard lock(mutex_);
  return filled_;
}

std::uint64_t FactsRing::lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

}  // namespace striate::viewer
