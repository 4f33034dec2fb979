#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "striate/platform/simulator/random_world/draft.hpp"

/// Stretches where the corridor itself is what is hard: narrow, dark, bent, blind.
namespace striate::simulator {
namespace {

/// Before and behind a place of another width: the robot turns there (by hand).
constexpr int kApproach_cm = 200;
/// A frame of 0.8 m, as deep as a wall is thick.
void put_frame(Draft& draft, int at_cm) {
  draft.other_width({at_cm, at_cm + draft.dice.throw_in_steps({12, 30}, 2)}, 80);
}

/// In a passage of `wide_cm`: a bin, a cupboard, or nothing.
std::string put_in_passage(Draft& draft, int at_cm, int wide_cm) {
  Dice& dice = draft.dice;
  switch (dice.throw_between({0, 2})) {
    case 0: {
      const int thick = dice.throw_in_steps({26, 36}, 2);
      draft.put(ObstacleKind::bin, "bin", {metres_of(at_cm), draft.at_a_wall_m(thick, wide_cm)},
                {thick, thick, dice.throw_between({45, 70})});
      return ", a bin in it";
    }
    case 1: {
      const SizeCm size{dice.throw_between({70, 110}), dice.throw_in_steps({34, 44}, 2),
                        dice.throw_between({110, 180})};
      draft.put(
          ObstacleKind::box, "cupboard",
          {metres_of(at_cm), draft.at_a_wall_m(std::min(size.y, wide_cm - kLane_cm), wide_cm)},
          {size.x, std::min(size.y, wide_cm - kLane_cm), size.z}, "dark_wood");
      return ", a cupboard in it";
    }
    default:
      return "";
  }
}

}  // namespace

void lay_pinch(Draft& draft) {
  constexpr int kNarrow_cm = 150;  // what rules leave of a corridor; see building_style.cpp
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  int at = from + kApproach_cm;
  std::string story;
  const bool frame = draft.width_cm < kNarrow_cm + 20 || draft.dice.chance(40);
  if (frame) {
    put_frame(draft, at);
    story = "a frame of 0.8 m";
    at += 40;
  } else {
    const int length = draft.dice.throw_between({250, 420});
    draft.other_width({at, at + length}, kNarrow_cm);
    story = "a passage of 1.5 m" + put_in_passage(draft, at + length / 2, kNarrow_cm);
    at += length;
  }
  if (draft.dice.chance(40)) {
    draft.somebody_comes_cm.push_back(at);
    story += ", and a person who comes";
  }
  draft.finish_stretch(from, at + kApproach_cm, first, story);
}

void lay_dark(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  const int to = from + draft.dice.throw_between({900, 1400});
  draft.dark.push_back({from, to});
  for (const Side side : {Side::left, Side::right}) {
    draft.world.walls.push_back({side, metres_of(from), metres_of(to), "blank_plaster"});
  }
  const std::string what = draft.put_furniture(from + draft.dice.throw_between({450, 600}));
  draft.finish_stretch(from, to, first, "dark between blank walls, a " + what + " in the way");
}

void lay_bend(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  Dice& dice = draft.dice;
  const int half = draft.width_cm / 2;
  const int at = from + half + kApproach_cm;
  int turn_deg = dice.sign() * (dice.chance(70) ? 90 : dice.throw_in_steps({35, 75}, 5));
  // Never back: the corridor cannot cross itself.
  if (std::abs(draft.heading_deg + turn_deg) > 90) turn_deg = -turn_deg;
  if (std::abs(draft.heading_deg + turn_deg) > 90) turn_deg /= 2;
  draft.world.turns.push_back({metres_of(at), radians(turn_deg)});
  draft.heading_deg += turn_deg;
  draft.unbroken.push_back({at - half - 100, at + half + 100});
  // Within a metre and a half of the bend, on either leg, and clear of its inner corner.
  const int away = half + dice.throw_between({30, 110});
  const std::string what = draft.put_furniture(at + dice.sign() * away);
  draft.finish_stretch(from, at + half + kApproach_cm, first,
                       fmt::format("a bend of {} degrees to the {}, a {} in it", std::abs(turn_deg),
                                   turn_deg > 0 ? "left" : "right", what));
}

void lay_pocket(Draft& draft) {
  constexpr int kDeep_cm = 600;  // as far ahead as the robot plans, and farther than it turns
  constexpr int kThick_cm = 10;  // of a screen
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  Dice& dice = draft.dice;
  // Each half takes the robot and lets it turn round.
  const int wide = std::max(draft.width_cm, dice.throw_in_steps({270, 330}, 2));
  const int mouth = from + kApproach_cm;
  const int end = mouth + kDeep_cm;
  if (wide > draft.width_cm) draft.other_width({from + 100, end + 150}, wide);
  const int height = std::min(200, draft.style.height_cm.low - 5);
  const std::string paint = dice.one_of(std::vector{"panelling", "paint_white", "plaster"});
  for (const int half : {1, 3}) {  // in two pieces, since a thing is at most 5 m long
    draft.put(ObstacleKind::box, "screen", {metres_of(mouth + half * kDeep_cm / 4), 0.0},
              {kDeep_cm / 2, kThick_cm, height}, paint);
  }
  const int closed = (wide - kThick_cm) / 2;
  const int side = dice.sign();
  draft.put(ObstacleKind::box, "screen",
            {metres_of(end - kThick_cm / 2), side * (wide + kThick_cm) / 400.0},
            {kThick_cm, closed, height}, paint);
  draft.finish_stretch(from, end + kApproach_cm, first,
                       fmt::format("a screen along the middle: the {} half is blind after 6 m",
                                   side > 0 ? "left" : "right"));
}

void lay_sunlight(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  Dice& dice = draft.dice;
  const int to = from + dice.throw_between({500, 800});
  const int side = dice.sign();
  draft.world.windows.push_back(
      {side > 0 ? Side::left : Side::right, metres_of(from + 50), metres_of(to - 50)});
  draft.sunny.push_back({from, to});
  // From outside these windows, at most 40 degrees off their middle.
  int azimuth_deg = draft.heading_deg + side * 90 + dice.throw_between({-40, 40});
  if (azimuth_deg > 180) azimuth_deg -= 360;
  if (azimuth_deg < -180) azimuth_deg += 360;
  draft.world.sun = Sun{radians(azimuth_deg), radians(dice.throw_between({15, 40})),
                        dice.throw_between({60, 100}) / 100.0};
  const std::string what = draft.put_furniture(from + (to - from) / 2);
  draft.finish_stretch(from, to, first,
                       fmt::format("sunlight through windows on the {}, a {} in it",
                                   side > 0 ? "left" : "right", what));
}

}  // namespace striate::simulator
