#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "striate/platform/simulator/random_world/draft.hpp"

/// Stretches with things in the way.
namespace striate::simulator {
namespace {

/// Before and behind a thing, with the next stretch's as much: room to turn and to come back into
/// the lane, three times the robot's length (by hand).
constexpr int kRoom_cm = 250;

/// Turned things cover more of the width: 0.02 for each degree and length is a little above the
/// sine.
int turned_across_cm(SizeCm size, int turn_deg) {
  return size.y + size.x * std::abs(turn_deg) * 2 / 100 + 1;
}

std::string put_parcel(Draft& draft, int at_cm) {
  const int longest = std::min(46, draft.reach_cm() - 8);
  const SizeCm size{draft.dice.throw_between({24, std::max(24, longest)}),
                    draft.dice.throw_between({20, std::clamp(longest, 20, 40)}),
                    draft.dice.throw_between({8, 15})};
  // Any turn: the diagonal is what it can cover, at most 1.3 times the longer side here.
  const int across = std::min(draft.reach_cm(), std::max(size.x, size.y) * 13 / 10);
  WorldObstacle& parcel =
      draft.put(ObstacleKind::cardboard_box, "parcel",
                {metres_of(at_cm), draft.beside_a_lane_m(across, draft.width_cm)}, size);
  parcel.turn_rad = radians(draft.dice.throw_between({-40, 40}));
  return fmt::format("a parcel {} cm high in the lane", size.z);
}

std::string put_plank(Draft& draft, int at_cm) {
  const SizeCm size{draft.dice.throw_between({120, 220}), draft.dice.throw_between({14, 24}),
                    draft.dice.throw_between({8, 10})};
  int turn_deg = draft.dice.throw_between({-15, 15});
  while (turned_across_cm(size, turn_deg) > draft.reach_cm()) turn_deg /= 2;
  WorldObstacle& plank = draft.put(
      ObstacleKind::box, "plank",
      {metres_of(at_cm), draft.beside_a_lane_m(turned_across_cm(size, turn_deg), draft.width_cm)},
      size, "wood");
  plank.turn_rad = radians(turn_deg);
  return fmt::format("a plank {} cm high on the floor", size.z);
}

/// From a wall into the way: a step or a cable duct.
std::string put_across(Draft& draft, int at_cm, const std::string& name, SizeCm size,
                       const std::string& image) {
  const int reach = draft.reach_cm();
  size.y = draft.dice.throw_between({reach * 6 / 10, reach});
  draft.put(ObstacleKind::box, name, {metres_of(at_cm), draft.at_a_wall_m(size.y, draft.width_cm)},
            size, image);
  return fmt::format("a {} {} cm high from the wall into the way", name, size.z);
}

/// A table is what hangs over: four legs, and a top at its height.
std::string put_hanging(Draft& draft, int at_cm, const std::string& name, SizeCm size,
                        bool at_the_wall) {
  size.y = std::min(size.y, draft.reach_cm());
  const double left = at_the_wall ? draft.at_a_wall_m(size.y, draft.width_cm)
                                  : draft.beside_a_lane_m(size.y, draft.width_cm);
  draft.put(ObstacleKind::table, name, {metres_of(at_cm), left}, size,
            draft.dice.one_of(std::vector{"wood", "paint_white", "dark_wood"}));
  return fmt::format("a {} whose top is {} cm above the floor", name, size.z);
}

}  // namespace

void lay_low_thing(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  const int at = from + kRoom_cm + draft.dice.throw_between({0, 100});
  std::string story;
  switch (draft.dice.throw_between({0, 4})) {
    case 0:
      story = put_plank(draft, at);
      break;
    case 1:
      story =
          put_across(draft, at, "step",
                     {draft.dice.throw_between({28, 40}), 0, draft.dice.throw_between({12, 15})},
                     draft.dice.one_of(std::vector{"concrete", "wood"}));
      break;
    case 2:
      story = put_across(draft, at, "cable_duct",
                         {draft.dice.throw_between({8, 14}), 0, draft.dice.throw_between({8, 10})},
                         draft.dice.one_of(std::vector{"paint_yellow", "paint_black"}));
      break;
    default:  // the most frequent by far (by hand)
      story = put_parcel(draft, at);
  }
  draft.finish_stretch(from, at + kRoom_cm, first, story);
}

void lay_overhang(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  const int at = from + kRoom_cm + draft.dice.throw_between({0, 100});
  Dice& dice = draft.dice;
  std::string story;
  switch (dice.throw_between({0, 2})) {
    case 0:
      story = put_hanging(draft, at, "bar_table",
                          {dice.throw_between({50, 80}), dice.throw_between({50, 140}),
                           dice.throw_between({100, 115})},
                          false);
      break;
    case 1:
      story = put_hanging(draft, at, "counter",
                          {dice.throw_between({80, 200}), dice.throw_between({45, 70}),
                           dice.throw_between({85, 110})},
                          true);
      break;
    default:
      story = put_hanging(draft, at, "shelf",
                          {dice.throw_between({80, 180}), dice.throw_between({28, 40}),
                           dice.throw_between({40, 100})},
                          true);
  }
  draft.finish_stretch(from, at + kRoom_cm, first, story);
}

void lay_thin_poles(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  const int count = draft.dice.throw_between({1, 3});
  int at = from + kRoom_cm;
  for (int i = 0; i < count; ++i) {
    const int thick = draft.dice.throw_in_steps({4, 8}, 2);
    draft.put(ObstacleKind::cylinder, "pole",
              {metres_of(at), draft.beside_a_lane_m(thick, draft.width_cm)},
              {thick, thick, draft.dice.throw_between({120, 190})},
              draft.dice.one_of(std::vector{"metal", "paint_grey", "paint_yellow"}));
    if (i + 1 < count) at += draft.dice.throw_between({180, 260});
  }
  draft.finish_stretch(from, at + kRoom_cm, first,
                       count == 1 ? "a thin pole" : fmt::format("{} thin poles", count));
}

void lay_late_thing(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  const int at = from + kRoom_cm + draft.dice.throw_between({0, 150});
  const std::string what = draft.put_furniture(at);
  // While the robot is 5 m to 8 m away: late, but not before its wheels (3 m at least are kept).
  const int ahead = draft.dice.throw_between({500, 800});
  draft.world.obstacles.back().appears_after_m = metres_of(std::max(50, at - ahead));
  draft.finish_stretch(from, at + kRoom_cm, first,
                       fmt::format("a {} that somebody puts there during the run", what));
}

void lay_furniture(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  int at = from + kRoom_cm;
  std::string story = draft.put_furniture(at);
  if (draft.dice.chance(50)) {
    at += draft.dice.throw_between({220, 320});
    story += " and " + draft.put_furniture(at);
  }
  draft.finish_stretch(from, at + kRoom_cm, first, story);
}

}  // namespace striate::simulator
