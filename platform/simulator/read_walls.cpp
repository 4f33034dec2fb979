#include <fmt/format.h>

#include <algorithm>

#include "striate/platform/simulator/world_entry.hpp"
#include "striate/platform/simulator/world_names.hpp"

/// What the walls are made of and what is in and on them.
namespace striate::simulator {
namespace {

using config::MapReader;
using config::Node;
using config::Unit;

void read_stretch(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a wall", world, diagnostics);
  WallStretch wall;
  entry.require_side(wall.side);
  entry.require_stretch(wall.from_m, wall.to_m);
  if (entry.map().require("material")) entry.map().text("material", wall.material);
  entry.finish();
  entry.check_image("material", wall.material, surface_names());
  if (entry.sound()) world.walls.push_back(wall);
}

/// Tells where a door, window or poster would stand across a step of the corridor's width or run
/// into a bend.
void check_on_one_wall(WorldEntry& entry, const World& world, const std::string& key, double from_m,
                       double to_m) {
  if (!entry.sound()) return;
  const auto tell = [&](double at_m, const char* what) {
    if (entry.sound() && from_m < at_m && at_m < to_m) {
      entry.add(key, fmt::format("stands across the {} at {}", what, metres(at_m)));
    }
  };
  for (const Widening& other : world.widenings) {
    tell(other.from_m, "step of the wall");
    tell(other.to_m, "step of the wall");
  }
  for (const Turn& turn : world.turns) tell(turn.at_m, "turn");
  if (entry.sound() && (from_m < 0.0 || to_m > world.length_m)) {
    entry.add(key, fmt::format("reaches from {} to {}, out of the corridor", metres(from_m),
                               metres(to_m)));
  }
}

void read_door(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a door", world, diagnostics);
  Door door;
  entry.require_side(door.side);
  entry.require_length("at", door.at_m, {-1000.0, 1000.0});
  entry.map().number("width", door.width_m, Unit::length, {0.4, 3.0});
  entry.map().number("height", door.height_m, Unit::length, {1.0, 10.0});
  entry.finish();
  if (entry.sound()) entry.check_along("at", door.at_m);
  check_on_one_wall(entry, world, "at", door.at_m - door.width_m / 2, door.at_m + door.width_m / 2);
  if (entry.sound() && door.height_m >= world.height_m) {
    entry.add("height", fmt::format("the corridor is only {} high", metres(world.height_m)));
  }
  for (const Door& other : world.doors) {
    const double apart = std::abs(other.at_m - door.at_m);
    if (entry.sound() && other.side == door.side && apart < (other.width_m + door.width_m) / 2) {
      entry.add("at", fmt::format("overlaps the door at {}", metres(other.at_m)));
    }
  }
  if (entry.sound()) world.doors.push_back(door);
}

/// A window of the row that would meet a door, a step of the wall or a bend is left out.
void read_window(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a row of windows", world, diagnostics);
  WindowRow row;
  entry.require_side(row.side);
  entry.require_stretch(row.from_m, row.to_m);
  entry.finish();
  if (entry.sound()) world.windows.push_back(row);
}

void read_poster(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a poster", world, diagnostics);
  Poster poster;
  entry.require_side(poster.side);
  entry.require_length("at", poster.at_m, {-1000.0, 1000.0});
  entry.map().number("height", poster.height_m, Unit::length, {0.1, 20.0});
  entry.map().numbers("size", {&poster.width_m, &poster.tall_m}, Unit::length, {0.05, 10.0});
  if (entry.map().require("image")) entry.map().text("image", poster.image);
  entry.finish();
  if (entry.sound()) entry.check_along("at", poster.at_m);
  check_on_one_wall(entry, world, "at", poster.at_m - poster.width_m / 2,
                    poster.at_m + poster.width_m / 2);
  if (entry.sound() && (poster.height_m - poster.tall_m / 2 < 0.0 ||
                        poster.height_m + poster.tall_m / 2 > world.height_m)) {
    entry.add("height",
              fmt::format("the poster would reach from {} to {} above the floor",
                          metres(poster.height_m - poster.tall_m / 2),
                          metres(poster.height_m + poster.tall_m / 2)),
              fmt::format("'height' is that of its middle; the corridor is {} high",
                          metres(world.height_m)));
  }
  entry.check_image("image", poster.image, picture_names());
  if (entry.sound()) world.posters.push_back(poster);
}

void read_surface(MapReader& root, const std::string& key, std::string& material,
                  const World& world) {
  if (!root.text(key, material)) return;
  WorldEntry entry(root.node(), "the world", world, root.diagnostics());
  entry.check_image(key, material, surface_names());
}

}  // namespace

void read_walls(MapReader& root, World& world) {
  config::Diagnostics& diagnostics = root.diagnostics();
  read_surface(root, "wall_material", world.wall_material, world);
  read_surface(root, "floor_material", world.floor_material, world);
  for_each_entry(root, "walls", [&](const Node& node) { read_stretch(node, world, diagnostics); });
  for_each_entry(root, "doors", [&](const Node& node) { read_door(node, world, diagnostics); });
  for_each_entry(root, "windows", [&](const Node& node) { read_window(node, world, diagnostics); });
  for_each_entry(root, "posters", [&](const Node& node) { read_poster(node, world, diagnostics); });
}

}  // namespace striate::simulator
