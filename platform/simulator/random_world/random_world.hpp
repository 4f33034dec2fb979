#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "striate/platform/simulator/passage.hpp"
#include "striate/platform/simulator/random_world/building_kind.hpp"
#include "striate/platform/simulator/random_world/drawn_stretch.hpp"
#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// So wide a way every drawn building has from start to goal by the true plan, with everything
/// standing: the robot is 0.43 m wide.
inline constexpr double kDrivable_m = 0.75;

/// A building that was drawn, read back by the reader, and found drivable.
struct RandomWorld {
  BuildingKind kind = BuildingKind::office;
  std::uint64_t seed = 0;
  World world;
  std::vector<Difficulty> difficulties;  ///< that it has, each once
  std::vector<DrawnStretch> stretches;
  std::string yaml;  ///< the world file
  Passage passage;
  int proposals = 1;  ///< drawn until one was drivable
};

/// "office_0007": the name of a drawn world and of its file.
[[nodiscard]] std::string random_world_name(BuildingKind kind, std::uint64_t seed);

/// Of what kind and seed the world of this name was drawn; nothing where it is no such name.
struct DrawnFrom {
  BuildingKind kind = BuildingKind::office;
  std::uint64_t seed = 0;
};
[[nodiscard]] std::optional<DrawnFrom> drawn_from(const std::string& name);

/// Draws the building of a kind and a seed: the same on every machine. A proposal without a way
/// that is wide enough is drawn again.
/// @throws std::runtime_error where none of many proposals is drivable; no seed is known for that
[[nodiscard]] RandomWorld draw_random_world(BuildingKind kind, std::uint64_t seed);

}  // namespace striate::simulator
