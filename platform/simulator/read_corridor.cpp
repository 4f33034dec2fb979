#include <fmt/format.h>

#include <cmath>

#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/shapes.hpp"
#include "striate/platform/simulator/world_entry.hpp"

/// The corridor's shape: length, other widths, turns, pillars.
namespace striate::simulator {
namespace {

using config::MapReader;
using config::Node;
using config::Unit;

void read_width(const Node& node, const std::string& what, World& world,
                config::Diagnostics& diagnostics) {
  WorldEntry entry(node, what, world, diagnostics);
  Widening other;
  entry.require_stretch(other.from_m, other.to_m);
  entry.require_length("width", other.width_m, {0.5, 50.0});
  entry.finish();
  if (!entry.sound()) return;
  const bool wider = what == "a widening";
  if (wider ? other.width_m <= world.width_m : other.width_m >= world.width_m) {
    entry.add("width",
              fmt::format("{} of {} in a corridor of {}", what, metres(other.width_m),
                          metres(world.width_m)),
              wider ? "narrow passages are written under 'narrowings'"
                    : "wide places are written under 'widenings'");
    return;
  }
  for (const Widening& before : world.widenings) {
    if (other.from_m < before.to_m && before.from_m < other.to_m) {
      entry.add("from", fmt::format("overlaps the other width from {} to {}", metres(before.from_m),
                                    metres(before.to_m)));
      return;
    }
  }
  world.widenings.push_back(other);
}

/// The mitre of a turn takes this much of the corridor on either side of it.
double mitre_m(const World& world, double angle_rad) {
  return world.width_m / 2 * std::tan(std::abs(angle_rad) / 2);
}

void check_turn(WorldEntry& entry, const World& world, const Turn& turn) {
  const double mitre = mitre_m(world, turn.angle_rad);
  const double before =
      world.turns.empty() ? 0.0
                          : world.turns.back().at_m + mitre_m(world, world.turns.back().angle_rad);
  if (turn.at_m - mitre <= before || turn.at_m + mitre >= world.length_m) {
    entry.add("at", fmt::format("a turn needs {} of corridor on either side", metres(mitre)),
              "turns are written in the order in which they come");
    return;
  }
  for (const Widening& other : world.widenings) {
    if (turn.at_m - mitre < other.to_m && turn.at_m + mitre > other.from_m) {
      entry.add("at", fmt::format("a turn within the other width from {} to {}",
                                  metres(other.from_m), metres(other.to_m)));
      return;
    }
  }
}

void read_turn(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a turn", world, diagnostics);
  Turn turn;
  entry.require_length("at", turn.at_m, {-1000.0, 1000.0});
  if (entry.map().require("angle")) {
    entry.map().number("angle", turn.angle_rad, Unit::angle, {radians(-135), radians(135)});
  }
  entry.finish();
  if (entry.sound()) entry.check_along("at", turn.at_m);
  if (entry.sound()) check_turn(entry, world, turn);
  if (!entry.sound()) return;
  world.turns.push_back(turn);
  const std::vector<Point2> outline = build_floor_plan(world).outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (std::size_t j = i + 2; j < outline.size(); ++j) {
      if (i == 0 && j + 1 == outline.size()) continue;
      if (segments_cross(outline[i], outline[i + 1], outline[j],
                         outline[(j + 1) % outline.size()])) {
        entry.add("at", "with this turn the corridor crosses itself");
        world.turns.pop_back();
        return;
      }
    }
  }
}

void read_pillar(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a pillar", world, diagnostics);
  Pillar pillar;
  entry.require_point("at", pillar.at);
  entry.map().number("diameter", pillar.diameter_m, Unit::length, {0.05, 3.0});
  entry.finish();
  entry.check_inside("at", pillar.at);
  if (entry.sound()) world.pillars.push_back(pillar);
}

}  // namespace

void read_corridor(MapReader& root, World& world) {
  if (root.require("corridor")) {
    if (const Node* node = root.raw("corridor")) {
      WorldEntry entry(*node, "the corridor", world, root.diagnostics());
      entry.require_length("length", world.length_m, {3.0, 1000.0});
      entry.map().number("width", world.width_m, Unit::length, {0.8, 50.0});
      entry.map().number("height", world.height_m, Unit::length, {1.5, 20.0});
      entry.finish();
    }
  }
  config::Diagnostics& diagnostics = root.diagnostics();
  for_each_entry(root, "widenings",
                 [&](const Node& node) { read_width(node, "a widening", world, diagnostics); });
  for_each_entry(root, "narrowings",
                 [&](const Node& node) { read_width(node, "a narrowing", world, diagnostics); });
  for_each_entry(root, "turns", [&](const Node& node) { read_turn(node, world, diagnostics); });
  for_each_entry(root, "pillars", [&](const Node& node) { read_pillar(node, world, diagnostics); });
}

}  // namespace striate::simulator
