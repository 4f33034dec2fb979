#pragma once

#include <cstdint>
#include <vector>

#include "striate/platform/simulator/random_world/draft.hpp"

/// What makes a drawn building hard.
namespace striate::simulator {

[[nodiscard]] std::vector<Difficulty> draw_difficulties(BuildingKind kind, std::uint64_t seed);

/// Each fault by itself in a quarter of the buildings, as large as heads that were calibrated once
/// and driven for a year have it (by hand; rolling shutters are read out in 10 ms to 33 ms).
[[nodiscard]] EyeFaults draw_eyes(BuildingKind kind, std::uint64_t seed);

}  // namespace striate::simulator
