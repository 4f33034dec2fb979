#pragma once

#include <hwy/targets.h>

#include <functional>
#include <string>
#include <vector>

/// Runs code once for every instruction set that this machine has and the vector code was built
/// for, slowest last; then everything is as before.
namespace striate::reference {

inline std::vector<std::int64_t> targets_of_this_machine() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::int64_t> result;
  for (std::int64_t target = 1; target > 0; target <<= 1) {
    if ((hwy::SupportedTargets() & target) != 0) result.push_back(target);
  }
  return result;
}

inline void on_every_target(const std::function<void(const std::string& name)>& run) {
  for (const std::int64_t target : targets_of_this_machine()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    run(hwy::TargetName(target));
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace striate::reference
