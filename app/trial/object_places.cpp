#include "striate/app/trial/object_places.hpp"

#include <cmath>
#include <numbers>

namespace striate::app {
namespace {

constexpr double kTeaching_m = 1.55;  // m from the object; about the middle of kDistances_m
/// 1 to 2.5 m; the farthest at which a landmark is expected (LandmarkFinderSettings)
constexpr double kDistances_m[] = {1.0, 1.5, 2.0, 2.5};
/// Each distance is tried from straight before it or from one side.
constexpr double kAside_deg[] = {0.0, 20.0, -20.0, 0.0};

/// Objects stand along the walls, so that the middle of the corridor is before them.
ObjectPlace place_before(const simulator::WorldObject& object, double distance_m,
                         double aside_rad) {
  const double away_rad =
      (object.at.y_m > 0.0 ? -0.5 : 0.5) * std::numbers::pi + aside_rad;  // from the object
  const Pose2 along{object.at.x_m + distance_m * std::cos(away_rad),
                    object.at.y_m + distance_m * std::sin(away_rad),
                    wrap_angle(away_rad + std::numbers::pi)};
  return {object.name, distance_m, aside_rad, along};
}

}  // namespace

ObjectPlace teaching_place(const simulator::WorldObject& object) {
  return place_before(object, kTeaching_m, 0.0);
}

std::vector<ObjectPlace> seeking_places(const simulator::WorldObject& object) {
  std::vector<ObjectPlace> places;
  for (std::size_t k = 0; k < std::size(kDistances_m); ++k) {
    places.push_back(place_before(object, kDistances_m[k], radians(kAside_deg[k])));
  }
  return places;
}

std::vector<std::string> objects_towards(const simulator::World& world, const Pose2& along,
                                         double bearing_rad, double within_rad) {
  std::vector<std::string> names;
  for (const simulator::WorldObject& object : world.objects) {
    const Point2 here = inverse_transform(along, object.at);
    const double off_rad = wrap_angle(std::atan2(here.y_m, here.x_m) - bearing_rad);
    if (std::abs(off_rad) <= within_rad) names.push_back(object.name);
  }
  return names;
}

}  // namespace striate::app
