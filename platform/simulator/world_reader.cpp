#include "striate/platform/simulator/world_reader.hpp"

#include <fmt/format.h>

#include "striate/config/map_reader.hpp"
#include "striate/config/yaml.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/start_place.hpp"
#include "striate/platform/simulator/static_shapes.hpp"
#include "striate/platform/simulator/world_entry.hpp"

namespace striate::simulator {
namespace {

using config::Diagnostics;
using config::MapReader;
using config::Node;
using config::Unit;

/// A world is made for the default robot; a larger one may not fit in.
constexpr RobotDescription kPioneer;

void read_start(MapReader& root, World& world) {
  const Node* node = root.raw("start");
  const Node whole = node != nullptr ? *node : root.node();
  WorldEntry entry(whole, "the start", world, root.diagnostics());
  if (node != nullptr) {
    Point2 at{world.start.x_m, world.start.y_m};
    entry.require_point("at", at);
    entry.map().number("heading", world.start.heading_rad, Unit::angle,
                       {radians(-360), radians(360)});
    entry.finish();
    world.start.x_m = at.x_m;
    world.start.y_m = at.y_m;
  }
  entry.check_inside("at", {world.start.x_m, world.start.y_m});
  if (!entry.sound()) return;
  const FloorPlan plan = build_floor_plan(world);
  Pose2 pose = plan.at(world.start.x_m, world.start.y_m);
  pose.heading_rad += world.start.heading_rad;
  const ConvexShape robot = moved(robot_footprint(kPioneer), pose);
  const std::string hit = overlapped_by(world, plan, robot);
  if (hit.empty()) return;
  entry.add("at", fmt::format("the start overlaps {}", hit),
            fmt::format("the robot reaches {} forward, {} back, and {} to either side",
                        metres(kPioneer.front_m), metres(kPioneer.rear_m),
                        metres(kPioneer.half_width_m)));
}

void read_goal(MapReader& root, World& world) {
  world.goal_beyond_m = world.length_m - 2.0;
  const Node* node = root.raw("goal");
  if (node == nullptr) return;
  WorldEntry entry(*node, "the goal", world, root.diagnostics());
  entry.require_length("beyond", world.goal_beyond_m, {-1000.0, 1000.0});
  entry.finish();
  if (!entry.sound()) return;
  entry.check_along("beyond", world.goal_beyond_m);
  const double reachable = world.length_m - kPioneer.front_m;
  if (entry.sound() && world.goal_beyond_m <= world.start.x_m) {
    entry.add("beyond", fmt::format("the goal ({}) must lie beyond the start ({})",
                                    metres(world.goal_beyond_m), metres(world.start.x_m)));
  } else if (entry.sound() && world.goal_beyond_m >= reachable) {
    entry.add("beyond", "the robot would touch the end wall before it reaches the goal",
              fmt::format("the middle of its axle gets to {} at most", metres(reachable)));
  }
}

void read_eyes(MapReader& root, World& world) {
  const Node* node = root.raw("eyes");
  if (node == nullptr) return;
  config::SettingsReader reader(*node, "eyes", root.diagnostics());
  visit(reader, world.eyes);
  reader.finish();
}

World read_root(const Node& node, Diagnostics& diagnostics) {
  World world;
  world.file = diagnostics.file();
  if (node.kind == Node::Kind::nothing) return world;  // the parser has said why
  MapReader root(node, "the world", diagnostics);
  if (node.kind != Node::Kind::map) return world;
  int version = 1;
  if (root.require("striate_world")) root.integer("striate_world", version, {1, 1});
  if (root.require("name")) root.text("name", world.name);
  // Each part is checked against those before it: the file's own order does not matter.
  read_corridor(root, world);
  read_walls(root, world);
  read_lights(root, world);
  read_things(root, world);
  read_people(root, world);
  read_eyes(root, world);
  read_start(root, world);
  read_goal(root, world);
  root.finish();
  return world;
}

}  // namespace

World parse_world(const std::string& text, Diagnostics& diagnostics) {
  diagnostics.set_source(text);
  return read_root(config::parse_yaml(text, diagnostics), diagnostics);
}

World read_world(Diagnostics& diagnostics) {
  return read_root(config::load_yaml(diagnostics), diagnostics);
}

World load_world(const std::string& file) {
  Diagnostics diagnostics(file);
  World world = read_world(diagnostics);
  diagnostics.throw_if_any();
  return world;
}

}  // namespace striate::simulator
