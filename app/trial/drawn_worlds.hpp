#pragma once

#include <cstdint>
#include <string>

#include "striate/app/trial/trial_plan.hpp"
#include "striate/platform/simulator/random_world/building_kind.hpp"

namespace striate::app {

/// The drawn buildings that a trial is to drive through.
struct DrawnWorldsOptions {
  std::string seeds;  ///< "1..200", both included
  std::string kind;   ///< empty: one kind after the other, by seed
};

/// The kind called so; where `kind` is empty that of the seed.
[[nodiscard]] simulator::BuildingKind building_kind_named(const std::string& kind,
                                                          std::uint64_t seed);

/// Draws the buildings into `OUT/worlds`, where they stay beside the results so that each can be
/// driven again, and makes them the trial's worlds, each with its own seed.
/// @throws UserError for seeds that are none, and where the folder holds other buildings of the
///         same names: then the results there are of others, too
void draw_trial_worlds(const DrawnWorldsOptions& drawn, TrialOptions& options);

}  // namespace striate::app
