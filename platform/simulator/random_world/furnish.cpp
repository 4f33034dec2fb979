#include <fmt/format.h>

#include <algorithm>

#include "striate/platform/simulator/random_world/draft.hpp"

/// What is everywhere in a drawn building: lamps, doors, windows, posters, people.
namespace striate::simulator {
namespace {

int length_cm(const Draft& draft) {
  return draft.x_cm;
}

bool meets(const std::vector<SpanCm>& spans, SpanCm span) {
  return std::any_of(spans.begin(), spans.end(), [&](const SpanCm& other) {
    return other.from < span.to && span.from < other.to;
  });
}

void hang_row(Draft& draft, SpanCm span, int every_cm, int percent) {
  if (span.to <= span.from) return;
  draft.world.lights.push_back(
      {metres_of(span.from), metres_of(span.to), metres_of(every_cm), percent / 100.0});
}

/// What hangs or stands on a wall between two doors.
void decorate(Draft& draft, Side side, SpanCm span) {
  Dice& dice = draft.dice;
  // Shipped posters and their sizes: A3 to A0 (ISO 216), by hand
  static const std::vector<const char*> kImages{"poster_fish",      "poster_map",
                                                "poster_notice",    "poster_art",
                                                "poster_timetable", "poster_landscape"};
  const int middle = (span.from + span.to) / 2;
  const bool window = dice.chance(draft.style.window_percent);
  const bool poster = dice.chance(draft.style.poster_percent);
  const int wide = dice.throw_in_steps({30, 84}, 2);
  const int height = dice.throw_between({130, 160});
  const char* image = dice.one_of(kImages);
  if (span.to - span.from < 160 || meets(draft.unbroken, span)) return;
  if (window) {
    draft.world.windows.push_back({side, metres_of(span.from), metres_of(span.to)});
  } else if (poster && metres_of(height) + 0.7 * metres_of(wide) < draft.world.height_m - 0.1) {
    // Paper is 1.41 times as tall as wide.
    draft.world.posters.push_back({side, metres_of(middle), metres_of(height), metres_of(wide),
                                   metres_of(wide * 141 / 100), image});
  }
}

void furnish_side(Draft& draft, Side side) {
  Dice& dice = draft.dice;
  int done = 60;
  while (true) {
    const int width = dice.throw_in_steps(draft.style.door_width_cm, 2);
    const int next = done + dice.throw_between(draft.style.door_every_cm);
    const SpanCm leaf{next - width / 2 - 30, next + width / 2 + 30};
    if (leaf.to > length_cm(draft) - 30) break;
    std::vector<SpanCm> taken = draft.unbroken;
    taken.insert(taken.end(), draft.sunny.begin(), draft.sunny.end());
    const SpanCm wall{done + 10, leaf.from};
    if (!meets(draft.sunny, wall) && !meets(draft.dark, wall)) decorate(draft, side, wall);
    if (!meets(taken, leaf)) {
      draft.world.doors.push_back({side, metres_of(next), metres_of(width), 1.98});
    }
    done = leaf.to;
  }
}

Walk walk_between(Draft& draft, int from_cm, int to_cm) {
  Dice& dice = draft.dice;
  const int half = draft.width_cm / 2 - 35;
  Walk walk;
  walk.points = {{metres_of(from_cm), metres_of(dice.throw_between({-half, half}))},
                 {metres_of(to_cm), metres_of(dice.throw_between({-half, half}))}};
  // Walking speeds of grown-ups indoors: 1.3 m/s and a spread of 0.3 m/s (Weidmann 1993).
  walk.speed_m_s = dice.throw_between({70, 160}) / 100.0;
  walk.from_s = dice.throw_between({0, 40});
  walk.carries = dice.chance(25);  // one in four has his hands full
  return walk;
}

}  // namespace

void hang_lamps(Draft& draft) {
  Dice& dice = draft.dice;
  const int every = dice.throw_in_steps(draft.style.lamp_every_cm, 20);
  const int percent = dice.throw_between(draft.style.lamp_percent);
  int done = 0;
  for (const SpanCm& dark : draft.dark) {
    hang_row(draft, {done, dark.from}, every, percent);
    hang_row(draft, dark, dice.throw_in_steps({600, 1200}, 50), dice.throw_between({3, 8}));
    done = dark.to;
  }
  hang_row(draft, {done, length_cm(draft)}, every, percent);
}

void furnish_walls(Draft& draft) {
  Dice& dice = draft.dice;
  draft.world.wall_material = dice.one_of(draft.style.walls);
  draft.world.floor_material = dice.one_of(draft.style.floors);
  // Before those of the dark stretches, which paint over them.
  std::vector<WallStretch> stretches;
  for (int i = dice.throw_between({0, 3}); i > 0; --i) {
    const int from = dice.throw_between({0, length_cm(draft) - 700});
    stretches.push_back({dice.chance(50) ? Side::left : Side::right, metres_of(from),
                         metres_of(from + dice.throw_between({250, 650})),
                         dice.one_of(draft.style.stretches)});
  }
  draft.world.walls.insert(draft.world.walls.begin(), stretches.begin(), stretches.end());
  furnish_side(draft, Side::left);
  furnish_side(draft, Side::right);
}

std::string send_people(Draft& draft, bool crowd) {
  Dice& dice = draft.dice;
  const int end = length_cm(draft) - 80;
  for (const int at : draft.somebody_comes_cm) {
    Walk walk = walk_between(draft, std::min(end, at + 900), std::max(150, at - 900));
    walk.from_s = std::max(0, at / 40 - 12);  // about when the robot is there, at 0.4 m/s
    draft.world.walks.push_back(walk);
  }
  const int walkers = crowd ? dice.throw_between({3, 6}) : dice.throw_between(draft.style.walkers);
  for (int i = 0; i < walkers; ++i) {
    const bool towards = dice.chance(60);
    const int near = dice.throw_between({150, end / 2});
    const int far = dice.throw_between({end / 2, end});
    Walk walk = walk_between(draft, towards ? far : near, towards ? near : far);
    walk.repeat = crowd || dice.chance(30);
    draft.world.walks.push_back(walk);
  }
  if (!crowd) return "";
  const int standers = dice.throw_between({1, 2});
  for (int i = 0; i < standers; ++i) {
    const int at = dice.throw_between({500, end - 200});
    const int beside = draft.width_cm / 2 - 28;
    draft.world.standers.push_back({{metres_of(at), dice.sign() * metres_of(beside)},
                                    radians(dice.throw_in_steps({-180, 170}, 10))});
  }
  draft.world.steps_in_front.push_back(
      {static_cast<double>(dice.throw_between({1, 3})), 1.0 * dice.throw_between({2, 4})});
  return fmt::format("a crowd: {} people to and fro, {} who stand, some who step in front", walkers,
                     standers);
}

}  // namespace striate::simulator
