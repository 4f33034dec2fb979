#pragma once

#include <memory>
#include <stdexcept>

#include "striate/memory/short_term/short_term_memory.hpp"

namespace striate::python {

/// Short-term memory as Python sees it: lent for one call, within one cycle. Whoever keeps it and
/// asks it later is told so, instead of reading what is no more.
class LentMemory {
 public:
  explicit LentMemory(const memory::ShortTermMemory& memory) : memory_(&memory) {}
  void end() { memory_ = nullptr; }
  /// @throws std::runtime_error when the call is over
  [[nodiscard]] const memory::ShortTermMemory& get() const {
    if (memory_ != nullptr) return *memory_;
    throw std::runtime_error(
        "this memory was lent for one call in one cycle, which is over; keep the values that you "
        "need instead");
  }

 private:
  const memory::ShortTermMemory* memory_;
};

/// Lends memory until the end of the scope.
class MemoryLoan {
 public:
  explicit MemoryLoan(const memory::ShortTermMemory& memory)
      : lent_(std::make_shared<LentMemory>(memory)) {}
  ~MemoryLoan() { lent_->end(); }
  MemoryLoan(const MemoryLoan&) = delete;
  MemoryLoan& operator=(const MemoryLoan&) = delete;

  [[nodiscard]] const std::shared_ptr<LentMemory>& lent() const { return lent_; }

 private:
  std::shared_ptr<LentMemory> lent_;
};

}  // namespace striate::python
