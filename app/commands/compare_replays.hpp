#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "striate/agent/replay/replay_mission.hpp"

/// A replay beside the run that was recorded.
namespace striate::app {

/// What came of running a recording again.
struct Comparison {
  std::uint64_t cycles = 0;
  std::uint64_t differing = 0;
  std::uint64_t first_cycle = 0;  ///< that differs; 0: none
  double first_s = 0.0;
  std::vector<std::string> first;  ///< what differs there

  /// What holds no cycle shows nothing.
  [[nodiscard]] bool identical() const { return cycles > 0 && differing == 0; }
  std::uint64_t gaps = 0;       ///< cycles that the recorder left out, within the file
  std::uint64_t first_gap = 0;  ///< the first of them
  double lasts_s = 0.0;
};

/// Takes the cycle that was just run again.
void compare(const agent::ReplayMission& mission, Comparison& result);

void print_text(const agent::ReplayMission& mission, const Comparison& result);

void print_as_json(const agent::ReplayMission& mission, const Comparison& result);

}  // namespace striate::app
