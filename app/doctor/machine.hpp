#pragma once

#include <cstdint>

#include "striate/app/doctor/finding.hpp"

namespace striate::app {

/// What a machine has; looked up by this_machine(), made up by tests.
struct Machine {
  unsigned cores = 0;
  std::string simd;                   ///< that the vision uses, "AVX2"; empty or "SCALAR": none
  std::uint64_t memory_bytes = 0;     ///< that programs can still get
  std::uint64_t disk_free_bytes = 0;  ///< where the program was started
};

[[nodiscard]] Machine this_machine();
[[nodiscard]] Findings look_at_machine(const Machine& machine);

}  // namespace striate::app
