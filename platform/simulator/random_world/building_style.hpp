#pragma once

#include <array>
#include <vector>

#include "striate/platform/simulator/random_world/dice.hpp"

namespace striate::simulator {

/// How buildings of one kind look and what is found in them. Lengths in whole centimetres, shares
/// in percent.
struct BuildingStyle {
  Between width_cm;
  Between height_cm;
  Between plain_stretches;  ///< with furniture alone, beside those with a difficulty
  Between lamp_every_cm;
  Between lamp_percent;  ///< 100: a bright office corridor
  std::vector<const char*> walls;
  std::vector<const char*> stretches;  ///< of other walls
  std::vector<const char*> floors;
  Between door_every_cm;  ///< from one door of a side to the next
  Between door_width_cm;
  int poster_percent = 0;  ///< of the places between doors
  int window_percent = 0;  ///< of the places between doors, where no sunlight is asked for
  Between walkers;         ///< without a crowd
  /// Share of the buildings in which each difficulty is found, in the order of Difficulty.
  std::array<int, kDifficulties> share_percent{};
};

[[nodiscard]] const BuildingStyle& style_of(BuildingKind kind);

}  // namespace striate::simulator
