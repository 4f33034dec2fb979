#pragma once

#include <memory>
#include <string>

#include "striate/agent/mission.hpp"
#include "striate/python/felt.hpp"
#include "striate/python/lent_memory.hpp"
#include "striate/python/seen.hpp"

namespace striate::python {

/// One cycle of a mission, for a callback. What is small is copied; images, the memory and what a
/// person could ask of the whole mission are there only during the call.
class ShownCycle {
 public:
  explicit ShownCycle(const agent::Mission& mission);
  /// The call is over.
  void end();

  /// @throws std::runtime_error when the call is over
  [[nodiscard]] const agent::Mission& mission() const;
  /// With images of its own where somebody asks during the call.
  [[nodiscard]] SharedSenses senses();
  [[nodiscard]] const std::shared_ptr<LentMemory>& memory() const { return loan_->lent(); }

  std::uint64_t number = 0;
  SharedSeen percept;
  behaviours::Wish wish;
  MotorCommand sent;
  std::string driver;
  std::string limited_by;  ///< "" for nothing
  std::string action;
  std::string doing;
  std::string hold;
  bool waits_for_reset = false;  ///< the hold lasts until then
  double progress_m = 0.0;

 private:
  const agent::Mission* mission_;
  SharedSenses senses_;
  bool with_images_ = false;
  std::unique_ptr<MemoryLoan> loan_;
};

}  // namespace striate::python
