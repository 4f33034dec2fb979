#pragma once

#include <string>
#include <vector>

/// The names that a world file may use for what ships with the program.
namespace striate::simulator {

/// Surfaces that repeat: "plaster", "brick".
[[nodiscard]] std::vector<std::string> surface_names();
/// Pictures for posters, book covers and boxes: "poster_fish".
[[nodiscard]] std::vector<std::string> picture_names();
/// The material of a puddle, which no wall has.
inline constexpr const char* kWet = "wet";
/// In the order of ObstacleKind.
[[nodiscard]] const std::vector<std::string>& obstacle_kinds();
[[nodiscard]] const std::vector<std::string>& object_kinds();

/// "did you mean 'brick'?", or all names where none is near.
[[nodiscard]] std::string suggestion(const std::string& wrong,
                                     const std::vector<std::string>& names);

}  // namespace striate::simulator
