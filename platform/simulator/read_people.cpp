#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/static_shapes.hpp"
#include "striate/platform/simulator/world_entry.hpp"

/// People: those who walk, those who step in front of the robot, those who stand.
namespace striate::simulator {
namespace {

using config::MapReader;
using config::Node;
using config::Unit;

/// A list of points: [[40 m, 0.3 m], [5 m, 0.3 m]].
std::vector<Point2> read_points(WorldEntry& entry, const Node& list,
                                config::Diagnostics& diagnostics) {
  std::vector<Point2> points;
  if (list.kind != Node::Kind::list || list.items.size() < 2) {
    entry.add("walk", "a walk is a list of two points or more",
              "write walk: [[40 m, 0.3 m], [5 m, 0.3 m]]");
    return points;
  }
  for (const Node& item : list.items) {
    if (item.kind != Node::Kind::list || item.items.size() != 2) {
      diagnostics.add(item.place, "a point is a list of two lengths, not " + item.describe(),
                      "write [40 m, 0.3 m]");
      continue;
    }
    const config::Range range{-1000.0, 1000.0};
    const auto x = config::read_quantity(item.items[0], Unit::length, range, diagnostics);
    const auto y = config::read_quantity(item.items[1], Unit::length, range, diagnostics);
    if (x && y) points.push_back({*x, *y});
  }
  return points;
}

bool has_room(const Pose2& at, const FloorPlan& plan, const std::vector<StaticShape>& things) {
  if (!inside_polygon({at.x_m, at.y_m}, plan.outline)) return false;
  const ConvexShape person = disc({at.x_m, at.y_m}, kPersonRadius_m);
  return std::none_of(things.begin(), things.end(), [&](const StaticShape& thing) {
    return distance_m(person, thing.shape) <= 0.0;
  });
}

/// The place nearest to `point` where a person has room between walls, pillars and obstacles: who
/// writes a walk need not measure the furniture.
void move_to_free(WorldEntry& entry, const World& world, const std::string& key, Point2& point) {
  entry.check_inside(key, point);
  if (!entry.sound()) return;
  const FloorPlan plan = build_floor_plan(world);
  std::vector<StaticShape> things = standing_shapes(world, plan);
  for (StaticShape& wall : wall_shapes(plan)) things.push_back(std::move(wall));
  // So exact is the nearest free place: a fifth of a person's radius
  constexpr double kStep_m = 0.05;
  constexpr int kRings = 20;       // up to 1 m away: the largest thing's half and a person
  constexpr int kDirections = 16;  // on each ring: 0.4 m apart on the outermost
  for (int ring = 0; ring <= kRings; ++ring) {
    for (int i = 0; i < (ring == 0 ? 1 : kDirections); ++i) {
      const double bearing_rad = 2.0 * std::numbers::pi * i / kDirections;
      const Point2 moved{point.x_m + kStep_m * ring * std::cos(bearing_rad),
                         point.y_m + kStep_m * ring * std::sin(bearing_rad)};
      if (!has_room(plan.at(moved.x_m, moved.y_m), plan, things)) continue;
      point = moved;
      return;
    }
  }
  entry.add(
      key,
      fmt::format("at {}, {} there is no room for a person", metres(point.x_m), metres(point.y_m)),
      fmt::format("a person needs {} to either side", metres(kPersonRadius_m)));
}

void read_walk(WorldEntry& entry, const Node& list, World& world,
               config::Diagnostics& diagnostics) {
  Walk walk;
  walk.points = read_points(entry, list, diagnostics);
  entry.map().number("speed", walk.speed_m_s, Unit::speed, {0.05, 3.0});
  entry.map().number("from", walk.from_s, Unit::duration, {0.0, 36000.0});
  entry.map().flag("repeat", walk.repeat);
  entry.map().flag("carries", walk.carries);
  entry.finish();
  for (Point2& point : walk.points) move_to_free(entry, world, "walk", point);
  if (entry.sound()) world.walks.push_back(walk);
}

void read_step_in_front(WorldEntry& entry, World& world) {
  StepInFront step;
  entry.map().number("step_in_front", step.per_minute, Unit::rate, {0.0, 0.5});
  step.per_minute *= 60.0;  // the reader gives 1/s
  entry.map().number("wait", step.wait_s, Unit::duration, {0.0, 60.0});
  entry.finish();
  if (entry.sound()) world.steps_in_front.push_back(step);
}

void read_stander(WorldEntry& entry, World& world) {
  Stander stander;
  entry.require_point("stand", stander.at);
  entry.map().number("heading", stander.heading_rad, Unit::angle, {radians(-360), radians(360)});
  entry.finish();
  move_to_free(entry, world, "stand", stander.at);
  if (entry.sound()) world.standers.push_back(stander);
}

void read_person(const Node& node, World& world, config::Diagnostics& diagnostics) {
  WorldEntry entry(node, "a person", world, diagnostics);
  if (node.kind != Node::Kind::map) return;
  const Node* walk = entry.map().raw("walk");
  const Node* step = entry.map().raw("step_in_front");
  const Node* stand = entry.map().raw("stand");
  const int ways = (walk != nullptr) + (step != nullptr) + (stand != nullptr);
  if (ways > 1) {
    diagnostics.add(node.place, "a person does one thing: walk, step_in_front, or stand",
                    "make an entry of its own for each");
  } else if (walk != nullptr) {
    read_walk(entry, *walk, world, diagnostics);
  } else if (step != nullptr) {
    read_step_in_front(entry, world);
  } else if (stand != nullptr) {
    read_stander(entry, world);
  } else {
    for (const char* key : {"speed", "from", "repeat", "carries", "wait", "heading"})
      entry.map().raw(key);
    diagnostics.add(node.place, "what does this person do?",
                    "write walk: [[x, y], ...], step_in_front: 2 per min, or stand: [x, y]");
    entry.finish();
  }
}

}  // namespace

void read_people(MapReader& root, World& world) {
  for_each_entry(root, "people",
                 [&](const Node& node) { read_person(node, world, root.diagnostics()); });
}

}  // namespace striate::simulator
