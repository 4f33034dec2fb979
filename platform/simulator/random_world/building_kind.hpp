#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace striate::simulator {

/// What kind of building a world is drawn of.
enum class BuildingKind { office, hospital, basement, school, old_house };

/// "office", "hospital", ...: in the order of BuildingKind.
[[nodiscard]] const std::vector<std::string>& building_kinds();

/// The kind of a seed where none is asked for: one after the other, so that seeds n to n + 4 have
/// one of each.
[[nodiscard]] BuildingKind kind_of_seed(std::uint64_t seed);

/// What makes a building hard to drive through.
enum class Difficulty {
  low_thing,    ///< 8 to 15 cm high: parcel, plank, step, cable duct
  overhang,     ///< at 0.4 to 1.15 m: bar table, counter, shelf
  pinch,        ///< 1.5 m wide, a frame of 0.8 m, a bin, a cupboard, a person coming
  dark,         ///< lamps at 0.03 to 0.08, blank walls, something in the way
  bend,         ///< a turn with a thing in it
  pocket,       ///< the half that the robot is in ends blind, the way on is beside it
  crowd,        ///< people who walk to and fro, stand, and step in front
  thin_pole,    ///< 4 to 8 cm thick
  sunlight,     ///< from the side, through windows
  late_thing,   ///< put down during the run
  ring,         ///< two ways round a block of rooms
  side_branch,  ///< blind arms: a T or a crossing, of which one way goes on
  glass,        ///< a double door of glass, one leaf shut
  stairs,       ///< that go down: no floor where floor should be
  wet_floor,    ///< a mirror, or a carpet
};
inline constexpr int kDifficulties = 15;

/// "low_thing": in the order of Difficulty.
[[nodiscard]] const std::vector<std::string>& difficulty_names();

}  // namespace striate::simulator
