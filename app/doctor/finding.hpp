#pragma once

#include <string>
#include <vector>

namespace striate::app {

/// One thing that `striate doctor` looked at.
struct Finding {
  enum class Grade {
    good,
    note,   ///< works, but is worth knowing
    wrong,  ///< something will not work
  };
  Grade grade = Grade::good;
  std::string about;  ///< "memory", "/dev/ttyUSB0"
  std::string what;   ///< in plain words
  std::string mend;   ///< what to do; empty where there is nothing to do
};

using Findings = std::vector<Finding>;

[[nodiscard]] inline bool any_wrong(const Findings& findings) {
  for (const Finding& finding : findings) {
    if (finding.grade == Finding::Grade::wrong) return true;
  }
  return false;
}

}  // namespace striate::app
