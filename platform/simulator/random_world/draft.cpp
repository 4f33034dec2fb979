#include "striate/platform/simulator/random_world/draft.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace striate::simulator {
namespace {

struct Furniture {
  ObstacleKind kind;
  const char* name;
  Between x_cm, y_cm, z_cm;
};

/// Sizes are those of furniture on sale, by hand.
const std::vector<Furniture>& furniture_list() {
  static const std::vector<Furniture> list{
      {ObstacleKind::table, "table", {80, 160}, {50, 80}, {70, 76}},
      {ObstacleKind::chair, "chair", {44, 52}, {44, 52}, {82, 96}},
      {ObstacleKind::cardboard_box, "carton", {30, 60}, {30, 50}, {30, 90}},
      {ObstacleKind::styrofoam_box, "styrofoam", {30, 50}, {30, 50}, {40, 90}},
      {ObstacleKind::box, "cupboard", {60, 120}, {34, 50}, {80, 180}},
      {ObstacleKind::plant, "plant", {36, 60}, {36, 60}, {80, 150}},
      {ObstacleKind::bin, "bin", {26, 40}, {26, 40}, {40, 70}},
      {ObstacleKind::sitter, "sitter", {72, 80}, {48, 52}, {122, 134}},
  };
  return list;
}

}  // namespace

WorldObstacle& Draft::put(ObstacleKind kind, const std::string& name, Point2 at, SizeCm size,
                          const std::string& image) {
  int number = 1;
  for (const WorldObstacle& other : world.obstacles) {
    number += other.name.substr(0, other.name.rfind('_')) == name ? 1 : 0;
  }
  WorldObstacle thing;
  thing.kind = kind;
  thing.name = fmt::format("{}_{}", name, number);
  thing.at = at;
  thing.size_x_m = metres_of(size.x);
  thing.size_y_m = metres_of(size.y);
  thing.size_z_m = metres_of(size.z);
  thing.image = image;
  world.obstacles.push_back(thing);
  return world.obstacles.back();
}

void Draft::other_width(SpanCm span, int other_cm) {
  // Doors, windows and posters keep so far from a step of the wall: a frame and a name plate.
  constexpr int kBesideStep_cm = 40;
  world.widenings.push_back({metres_of(span.from), metres_of(span.to), metres_of(other_cm)});
  for (const int step : {span.from, span.to}) {
    unbroken.push_back({step - kBesideStep_cm, step + kBesideStep_cm});
  }
}

int Draft::reach_cm() const {
  return width_cm - kLane_cm;
}

double Draft::beside_a_lane_m(int across_cm, int wide_cm) {
  const int room = std::max(0, wide_cm - kLane_cm - across_cm);
  const int from_wall = dice.throw_between({0, room});
  // Twice the middle's distance is whole: halves of centimetres are exact.
  return dice.sign() * (wide_cm - across_cm - 2 * from_wall) / 200.0;
}

double Draft::at_a_wall_m(int across_cm, int wide_cm) {
  return dice.sign() * (wide_cm - across_cm) / 200.0;
}

std::string Draft::put_furniture(int at_cm) {
  std::vector<const Furniture*> fitting;
  for (const Furniture& one : furniture_list()) {
    if (one.y_cm.low <= reach_cm() && one.z_cm.low < style.height_cm.low - 20) {
      fitting.push_back(&one);
    }
  }
  const Furniture& one = *dice.one_of(fitting);
  const SizeCm size{dice.throw_between(one.x_cm),
                    dice.throw_between({one.y_cm.low, std::min(one.y_cm.high, reach_cm())}),
                    dice.throw_between(one.z_cm)};
  put(one.kind, one.name, {metres_of(at_cm), beside_a_lane_m(size.y, width_cm)}, size,
      one.kind == ObstacleKind::box ? dice.one_of(std::vector{"dark_wood", "wood", "paint_grey"})
                                    : "");
  return one.name;
}

void Draft::finish_stretch(int from_cm, int to_cm, std::size_t first_obstacle,
                           const std::string& story) {
  stretches.push_back(
      {metres_of(from_cm), metres_of(to_cm), story, first_obstacle, world.obstacles.size()});
  x_cm = to_cm;
}

}  // namespace striate::simulator
