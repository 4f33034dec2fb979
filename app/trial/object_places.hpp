#pragma once

#include <string>
#include <vector>

#include "striate/platform/simulator/scene.hpp"

namespace striate::app {

/// A place from which an object of a world is looked at.
struct ObjectPlace {
  std::string object;
  double distance_m = 0.0;
  double aside_rad = 0.0;  ///< from the line that leads straight from its wall
  Pose2 along;             ///< corridor coordinates: the robot faces the object
};

/// Where the robot is put to be taught: straight before the object.
[[nodiscard]] ObjectPlace teaching_place(const simulator::WorldObject& object);

/// Where the robot is put to seek it: at several distances, straight before it and aside.
[[nodiscard]] std::vector<ObjectPlace> seeking_places(const simulator::WorldObject& object);

/// The names of the objects that stand within `within_rad` of a direction as seen from a place.
[[nodiscard]] std::vector<std::string> objects_towards(const simulator::World& world,
                                                       const Pose2& along, double bearing_rad,
                                                       double within_rad);

}  // namespace striate::app
