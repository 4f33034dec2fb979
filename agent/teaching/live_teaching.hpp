#pragma once

#include <functional>
#include <string>
#include <vector>

#include "striate/agent/mission.hpp"
#include "striate/memory/long_term/records.hpp"

namespace striate::agent {

/// What a robot saw of a thing that it was shown.
struct LiveViews {
  std::vector<memory::StoredView> views;  ///< with range, bearing and image
  int looked_in_vain = 0;  ///< looks in which no thing could be told from its surroundings
  RunResult result;        ///< of the task
};

/// Runs a task that looks at a thing (one with the behaviour `teach`) and takes its views. Keeps
/// nothing.
/// @param each_cycle may ask for a safe end, as Mission::run
/// @throws UserError for mistakes in what was given
[[nodiscard]] LiveViews take_views(const MissionOptions& mission, const BodySource& body,
                                   const Mission::EachCycle& each_cycle);

/// The sound views: those with enough structure to be recognised at all. What is left out is said.
[[nodiscard]] std::vector<memory::StoredView> with_structure(
    const std::vector<memory::StoredView>& views, const memory::LongTermSettings& settings,
    std::vector<std::string>& remarks);

}  // namespace striate::agent
