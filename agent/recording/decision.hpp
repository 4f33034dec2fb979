#pragma once

#include <string>
#include <vector>

#include "striate/agent/cognitive_cycle.hpp"
#include "striate/platform/replay/recording.hpp"

namespace striate::agent {

/// What the robot decided in the cycle that it has just made. `interrupted` is not filled in.
void note_decision(const CycleTrace& trace, const tasks::Executive& executive,
                   replay::RecordedDecision& decision);

/// What is not the same, bit for bit: "wish forward 0.31 m/s (then 0.30 m/s)"; empty: nothing.
[[nodiscard]] std::vector<std::string> differences(const replay::RecordedDecision& now,
                                                   const replay::RecordedDecision& then);

}  // namespace striate::agent
