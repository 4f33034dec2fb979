#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "striate/viewer/channels/cycle_facts.hpp"

namespace striate::viewer {

/// Facts of cycles on their way from the mission to a thread of the viewer's own. The cycle never
/// waits for the other side: where no slot is free, the whole cycle is left out and counted.
class FactsRing {
 public:
  explicit FactsRing(std::size_t slots) : slots_(slots) {}

  // The cycle's side.
  /// @param fill gets the slot, with the facts of a cycle before. @return false: no slot was free
  bool put(const std::function<void(CycleFacts&)>& fill);
  /// Nothing follows.
  void end();

  // The thread's side.
  /// The oldest that waits, until pop(); nullptr: none.
  [[nodiscard]] const CycleFacts* front() const;
  /// The same, but waits for one; nullptr: nothing follows.
  [[nodiscard]] const CycleFacts* wait_for_front();
  void pop();
  /// How many wait, that of front() among them.
  [[nodiscard]] std::size_t waiting() const;

  /// Cycles that were put in.
  [[nodiscard]] std::uint64_t filled() const;
  /// Cycles for which no slot was free.
  [[nodiscard]] std::uint64_t lost() const;

 private:
  mutable std::mutex mutex_;  ///< guards which slots are filled, not what is in them
  std::condition_variable wake_;
  std::uint64_t filled_ = 0;
  std::uint64_t emptied_ = 0;
  std::uint64_t lost_ = 0;
  bool ended_ = false;
  std::vector<CycleFacts> slots_;
};

}  // namespace striate::viewer
