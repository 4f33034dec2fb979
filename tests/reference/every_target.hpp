#pragma once

#include <hwy/targets.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "striate/base/instruction_set.hpp"

/// Runs code once for every instruction set that this machine has and the vector code was built
/// for, slowest last; then everything is as before.
namespace striate::reference {

/// From here on the vector code uses what it has of these targets of Highway; 0: of the machine's.
inline void restrict_vector_code(std::int64_t targets) {
  hwy::SetSupportedTargetsForTest(targets);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

struct Target {
  std::int64_t bit;
  std::string name;  ///< as the vector code says when it is restricted to that target
};

/// Highway also tells what the vector code was not built for (SVE), where it falls back to another
/// one, and does not tell NEON where the processor lacks AES: so the vector code itself is asked.
inline std::vector<Target> targets_of_this_machine() {
  restrict_vector_code(0);
  const std::int64_t supported = hwy::SupportedTargets();
  std::vector<Target> result;
  for (std::int64_t target = 1; target > 0; target <<= 1) {
    if ((supported & target) == 0) continue;
    restrict_vector_code(target);
    const std::string name(instruction_set());
    const auto same = [&](const Target& other) { return other.name == name; };
    if (std::none_of(result.begin(), result.end(), same)) result.push_back({target, name});
  }
  restrict_vector_code(0);
  return result;
}

inline void on_every_target(const std::function<void(const std::string& name)>& run) {
  for (const Target& target : targets_of_this_machine()) {
    restrict_vector_code(target.bit);
    run(target.name);
  }
  restrict_vector_code(0);
}

}  // namespace striate::reference
