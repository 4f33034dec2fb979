#include "striate/platform/simulator/world_entry.hpp"

/// Lamps and sun.
namespace striate::simulator {
namespace {

using config::MapReader;
using config::Node;
using config::Unit;

void read_lamps(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a row of lights", world, diagnostics);
  LightRow row;
  entry.require_stretch(row.from_m, row.to_m);
  entry.map().number("every", row.every_m, Unit::length, {0.5, 100.0});
  entry.map().number("level", row.level, Unit::none, {0.0, 4.0});
  entry.map().number("left", row.left_m, Unit::length, {-0.5 * world.width_m, 0.5 * world.width_m});
  entry.finish();
  if (entry.sound()) world.lights.push_back(row);
}

}  // namespace

void read_lights(MapReader& root, World& world) {
  for_each_entry(root, "lights",
                 [&](const Node& node) { read_lamps(node, world, root.diagnostics()); });
  const Node* node = root.raw("sun");
  if (node == nullptr) return;
  WorldEntry entry(*node, "the sun", world, root.diagnostics());
  Sun sun;
  sun.level = 1.0;
  if (entry.map().require("azimuth")) {
    entry.map().number("azimuth", sun.azimuth_rad, Unit::angle, {radians(-360), radians(360)});
  }
  if (entry.map().require("elevation")) {
    entry.map().number("elevation", sun.elevation_rad, Unit::angle, {radians(1), radians(90)});
  }
  entry.map().number("level", sun.level, Unit::none, {0.0, 4.0});
  entry.finish();
  if (entry.sound()) world.sun = sun;
}

}  // namespace striate::simulator
