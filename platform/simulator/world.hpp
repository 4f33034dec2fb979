#pragma once

#include <optional>
#include <string>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/platform/simulator/eye_faults.hpp"

/// What a world file says, in SI units and radians. x runs along the corridor's centre line, y to
/// its left, the middle of the start wall is the origin. In a corridor with turns x goes on along
/// the bent centre line; FloorPlan turns (x, y) into the flat plan that everything else uses.
namespace striate::simulator {

enum class Side { left, right };

struct Widening {  ///< also a narrowing: another width over a stretch
  double from_m = 0.0;
  double to_m = 0.0;
  double width_m = 0.0;
};

struct Turn {  ///< the corridor bends here; left is positive
  double at_m = 0.0;
  double angle_rad = 0.0;
};

struct Pillar {
  Point2 at;
  double diameter_m = 0.4;
};

struct WallStretch {
  Side side = Side::left;
  double from_m = 0.0;
  double to_m = 0.0;
  std::string material;  ///< a shipped material's name, or the path of an image file
};

struct Door {
  Side side = Side::left;
  double at_m = 0.0;  ///< its middle
  double width_m = 0.95;
  double height_m = 2.05;
};

struct WindowRow {
  Side side = Side::right;
  double from_m = 0.0;
  double to_m = 0.0;
};

struct Poster {
  Side side = Side::left;
  double at_m = 0.0;
  double height_m = 1.5;  ///< of its middle
  double width_m = 0.6;
  double tall_m = 0.9;
  std::string image;  ///< a shipped image's name, or the path of an image file
};

struct LightRow {
  double from_m = 0.0;
  double to_m = 0.0;
  double every_m = 4.0;
  double level = 1.0;   ///< 0 dark .. 1 as bright as an office corridor
  double left_m = 0.0;  ///< of the middle
};

struct Sun {
  double azimuth_rad = 0.0;  ///< the direction that the light comes from, from +x to the left
  double elevation_rad = 0.0;
  double level = 0.0;
};

/// A `wall` is masonry from floor to ceiling, for branches, rings and blind ends. A `glass` pane
/// stands in a frame. `stairs` go down along their x: a hole in the floor. A `sitter` is a person
/// on a chair, who looks along x and stays.
enum class ObstacleKind {
  table,
  chair,
  cardboard_box,
  styrofoam_box,
  box,
  cylinder,
  plant,
  bin,
  wall,
  glass,
  stairs,
  sitter,
};

struct WorldObstacle {
  ObstacleKind kind = ObstacleKind::box;
  std::string name;  ///< for results; made of kind and number where not given
  Point2 at;         ///< its middle
  double turn_rad = 0.0;
  double size_x_m = 0.0;  ///< 0: the kind's own size
  double size_y_m = 0.0;
  double size_z_m = 0.0;
  std::string image;             ///< texture of its sides; empty: the kind's own
  double from_s = 0.0;           ///< not there before this time of the run
  double appears_after_m = 0.0;  ///< not there before the robot has driven so far
};

/// Carpet, a puddle: lies flat on the floor and stops nobody.
struct FloorPatch {
  Point2 at;  ///< its middle
  double turn_rad = 0.0;
  double size_x_m = 1.0;
  double size_y_m = 1.0;
  std::string material;  ///< a shipped surface, an image file, or "wet"
};

struct WorldObject {  ///< a thing that can be taught and sought
  std::string kind;   ///< box, book, cup
  std::string name;
  Point2 at;
  double height_m = 0.0;  ///< of its foot above the floor
  double turn_rad = 0.0;
  double size_x_m = 0.0;
  double size_y_m = 0.0;
  double size_z_m = 0.0;
  std::string image;
};

struct Walk {  ///< a person who walks along points, once or to and fro
  std::vector<Point2> points;
  double speed_m_s = 1.0;
  double from_s = 0.0;
  bool repeat = false;
  bool carries = false;  ///< a small box before the chest
};

struct StepInFront {  ///< people who step before the robot now and then
  double per_minute = 0.0;
  double wait_s = 3.0;
};

struct Stander {  ///< a person who stands still
  Point2 at;
  double heading_rad = 0.0;
};

struct World {
  std::string file;  ///< where it was read from, for messages
  std::string name;
  double length_m = 60.0;
  double width_m = 2.4;
  double height_m = 2.7;
  std::vector<Widening> widenings;
  std::vector<Turn> turns;
  std::vector<Pillar> pillars;
  std::vector<WallStretch> walls;
  std::string wall_material = "plaster";
  std::string floor_material = "linoleum";
  std::vector<Door> doors;
  std::vector<WindowRow> windows;
  std::vector<Poster> posters;
  std::vector<LightRow> lights;
  std::optional<Sun> sun;
  std::vector<WorldObstacle> obstacles;
  std::vector<FloorPatch> floor_patches;
  std::vector<WorldObject> objects;
  std::vector<Walk> walks;
  std::vector<StepInFront> steps_in_front;
  std::vector<Stander> standers;
  Pose2 start{1.0, 0.0, 0.0};
  double goal_beyond_m = 58.0;
  EyeFaults eyes;  ///< what is wrong with the cameras in this world
};

}  // namespace striate::simulator
