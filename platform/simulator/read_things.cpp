#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "striate/platform/simulator/static_shapes.hpp"
#include "striate/platform/simulator/world_entry.hpp"
#include "striate/platform/simulator/world_names.hpp"

/// Obstacles and the objects that can be taught and sought.
namespace striate::simulator {
namespace {

using config::MapReader;
using config::Node;
using config::Unit;

/// Things may wear images and surfaces alike.
std::vector<std::string> all_names() {
  std::vector<std::string> names = picture_names();
  for (std::string& name : surface_names()) names.push_back(std::move(name));
  return names;
}

/// A thing may stand against a wall and even reach into it, but half of its size must be clear.
void check_between_walls(WorldEntry& entry, const World& world, const WorldObstacle& obstacle) {
  if (!entry.sound()) return;
  const FloorPlan plan = build_floor_plan(world);
  const Pose2 middle = plan.at(obstacle.at.x_m, obstacle.at.y_m);
  for (ConvexShape shape : obstacle_outline(obstacle, plan)) {
    shape.radius_m /= 2.0;
    for (Point2& corner : shape.corners) {
      corner = {(middle.x_m + corner.x_m) / 2.0, (middle.y_m + corner.y_m) / 2.0};
    }
    for (const StaticShape& wall : wall_shapes(plan)) {
      if (distance_m(shape, wall.shape) > 0.0) continue;
      entry.add("at", fmt::format("'{}' stands in a wall", obstacle.name),
                "'at' is the middle of the thing");
      return;
    }
  }
}

/// As long as a corridor may be
constexpr double kLongestWall_m = 1000.0;

/// Nobody digs a stairwell during a run.
void check_stairs(WorldEntry& entry, const WorldObstacle& obstacle) {
  if (obstacle.kind != ObstacleKind::stairs || !entry.sound()) return;
  const bool late = obstacle.from_s > 0.0 || obstacle.appears_after_m > 0.0;
  if (!late) return;
  entry.add(obstacle.from_s > 0.0 ? "from" : "appears_after", "stairs are there from the beginning",
            "leave it out");
}

void read_obstacle(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "an obstacle", world, diagnostics);
  WorldObstacle obstacle;
  int kind = 0;
  if (entry.map().require("kind")) entry.map().choice("kind", kind, obstacle_kinds());
  obstacle.kind = static_cast<ObstacleKind>(kind);
  entry.map().text("name", obstacle.name);
  entry.require_point("at", obstacle.at);
  entry.map().number("turn", obstacle.turn_rad, Unit::angle, {radians(-360), radians(360)});
  entry.map().numbers("size", {&obstacle.size_x_m, &obstacle.size_y_m, &obstacle.size_z_m},
                      Unit::length,
                      {0.02, obstacle.kind == ObstacleKind::wall ? kLongestWall_m : 5.0});
  entry.map().text("image", obstacle.image);
  entry.map().number("from", obstacle.from_s, Unit::duration, {0.0, 86400.0});
  entry.map().number("appears_after", obstacle.appears_after_m, Unit::length, {0.0, 100000.0});
  entry.finish();
  entry.check_inside("at", obstacle.at);
  if (!obstacle.image.empty()) entry.check_image("image", obstacle.image, all_names());
  if (!entry.sound()) return;
  if (obstacle.name.empty()) {
    int number = 1;
    for (const WorldObstacle& other : world.obstacles) number += other.kind == obstacle.kind;
    obstacle.name = fmt::format("{}_{}", obstacle_kinds()[static_cast<std::size_t>(kind)], number);
  }
  for (const WorldObstacle& other : world.obstacles) {
    if (other.name == obstacle.name) {
      entry.add("name", fmt::format("another obstacle is called '{}'", other.name));
      return;
    }
  }
  check_stairs(entry, obstacle);
  check_between_walls(entry, world, obstacle);
  if (entry.sound()) world.obstacles.push_back(obstacle);
}

void read_floor_patch(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a floor patch", world, diagnostics);
  FloorPatch patch;
  entry.require_point("at", patch.at);
  entry.map().number("turn", patch.turn_rad, Unit::angle, {radians(-360), radians(360)});
  if (entry.map().require("size")) {
    entry.map().numbers("size", {&patch.size_x_m, &patch.size_y_m}, Unit::length, {0.05, 100.0});
  }
  if (entry.map().require("material")) entry.map().text("material", patch.material);
  entry.finish();
  entry.check_inside("at", patch.at);
  if (patch.material != kWet) {
    std::vector<std::string> names = surface_names();
    names.emplace_back(kWet);
    entry.check_image("material", patch.material, names);
  }
  if (entry.sound()) world.floor_patches.push_back(patch);
}

void read_object(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "an object", world, diagnostics);
  WorldObject object;
  int kind = 0;
  if (entry.map().require("kind")) entry.map().choice("kind", kind, object_kinds());
  object.kind = object_kinds()[static_cast<std::size_t>(kind)];
  if (entry.map().require("name")) entry.map().text("name", object.name);
  if (entry.map().require("at")) {
    entry.map().numbers("at", {&object.at.x_m, &object.at.y_m, &object.height_m}, Unit::length,
                        {-1000.0, 1000.0});
  }
  entry.map().number("turn", object.turn_rad, Unit::angle, {radians(-360), radians(360)});
  entry.map().numbers("size", {&object.size_x_m, &object.size_y_m, &object.size_z_m}, Unit::length,
                      {0.01, 5.0});
  entry.map().text("image", object.image);
  entry.finish();
  entry.check_inside("at", object.at);
  if (entry.sound() && (object.height_m < 0.0 || object.height_m > world.height_m)) {
    entry.add("at", fmt::format("{} above the floor is not within the corridor",
                                metres(object.height_m)));
  }
  if (!object.image.empty()) entry.check_image("image", object.image, all_names());
  for (const WorldObject& other : world.objects) {
    if (entry.sound() && other.name == object.name) {
      entry.add("name", fmt::format("another object is called '{}'", other.name));
    }
  }
  if (entry.sound()) world.objects.push_back(object);
}

}  // namespace

void read_things(MapReader& root, World& world) {
  config::Diagnostics& diagnostics = root.diagnostics();
  for_each_entry(root, "obstacles",
                 [&](const Node& node) { read_obstacle(node, world, diagnostics); });
  for_each_entry(root, "floor_patches",
                 [&](const Node& node) { read_floor_patch(node, world, diagnostics); });
  for_each_entry(root, "objects", [&](const Node& node) { read_object(node, world, diagnostics); });
}

}  // namespace striate::simulator
