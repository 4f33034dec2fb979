#pragma once

#include "tests/reference/flat_world.hpp"

/// Random corridors for closed-loop tests: 2.4 m wide, with things to go round, gaps down to
/// 0.8 m, a widening with pillars, blank walls and people. Always passable.
namespace striate::flat {

inline constexpr double kHalfCorridor_m = 1.2;

/// Both walls from x = -1 to `to_m`, in stretches of which some are blank.
inline void add_walls(Layout& layout, double from_m, double to_m, double half_m, Random& random,
                      double blank_share) {
  for (const double side : {1.0, -1.0}) {
    double x = from_m;
    while (x < to_m) {
      const double next = std::min(to_m, x + random.between(1.5, 4.0));
      layout.faces.push_back(
          {{x, side * half_m}, {next, side * half_m}, 0.0, 2.7, random.chance(blank_share)});
      x = next;
    }
  }
}

inline void add_widening(Layout& layout, double from_m, double to_m, double half_m) {
  for (const double side : {1.0, -1.0}) {
    const double a = side * kHalfCorridor_m;
    const double b = side * half_m;
    layout.faces.push_back({{from_m, a}, {from_m, b}, 0.0, 2.7, false});
    layout.faces.push_back({{from_m, b}, {to_m, b}, 0.0, 2.7, false});
    layout.faces.push_back({{to_m, b}, {to_m, a}, 0.0, 2.7, false});
  }
  const double middle = 0.5 * (from_m + to_m);
  layout.columns.push_back({{middle - 1.3, 0.75}, 0.22, 2.7});
  layout.columns.push_back({{middle + 1.3, -0.75}, 0.22, 2.7});
}

inline void add_chair(Layout& layout, Point2 at, double turn_rad) {
  const Pose2 pose{at.x_m, at.y_m, turn_rad};
  for (const double a : {-0.19, 0.19}) {
    for (const double b : {-0.19, 0.19}) {
      layout.columns.push_back({transform(pose, Point2{a, b}), 0.02, 0.45});
    }
  }
  add_box(layout, at, 0.40, 0.40, turn_rad, 0.40, 0.47);
  add_box(layout, transform(pose, Point2{-0.19, 0.0}), 0.03, 0.40, turn_rad, 0.47, 0.90);
}

inline void add_table(Layout& layout, Point2 at, double turn_rad) {
  const Pose2 pose{at.x_m, at.y_m, turn_rad};
  for (const double a : {-0.45, 0.45}) {
    for (const double b : {-0.27, 0.27}) {
      layout.columns.push_back({transform(pose, Point2{a, b}), 0.025, 0.72});
    }
  }
  add_box(layout, at, 1.0, 0.6, turn_rad, 0.69, 0.75);
}

/// One thing to get past at `x_m`; `side` is where it stands.
inline void add_hurdle(Layout& layout, double x_m, double side, Random& random) {
  const double kind = random.unit();
  if (kind < 0.30) {  // a box of any height beside the middle
    const double size = random.between(0.3, 0.6);
    const double y = side * random.between(0.25, kHalfCorridor_m - 0.5 * size);
    add_box(layout, {x_m, y}, size, size, random.between(-0.4, 0.4), 0.0,
            random.between(0.25, 1.2));
  } else if (kind < 0.42) {
    add_table(layout, {x_m, side * random.between(0.45, 0.85)}, random.between(-0.2, 0.2));
  } else if (kind < 0.55) {
    add_chair(layout, {x_m, side * random.between(0.3, 0.9)}, random.between(-3.0, 3.0));
  } else if (kind < 0.75) {  // a gap between two boxes
    const double gap = random.between(0.80, 1.05);
    const double y = side * random.between(0.0, 0.45);
    const double left = kHalfCorridor_m - (y + 0.5 * gap);
    const double right = kHalfCorridor_m + (y - 0.5 * gap);
    add_box(layout, {x_m, kHalfCorridor_m - 0.5 * left}, 0.4, left, 0.0, 0.0,
            random.between(0.4, 1.5));
    add_box(layout, {x_m, -kHalfCorridor_m + 0.5 * right}, 0.4, right, 0.0, 0.0,
            random.between(0.4, 1.5));
  } else if (kind < 0.85) {  // half of the corridor is shut
    const double wide = random.between(1.0, 1.5);
    add_box(layout, {x_m, side * (kHalfCorridor_m - 0.5 * wide)}, 0.3, wide, 0.0, 0.0, 1.0);
  } else if (kind < 0.92) {
    layout.columns.push_back({{x_m, side * random.between(0.0, 0.6)}, 0.2, 1.0});
  } else {  // someone stands there
    Person stander;
    stander.path = {{x_m, side * random.between(0.1, 0.8)}};
    stander.starts_at_m = -1e9;
    layout.people.push_back(stander);
  }
}

inline void add_person(Layout& layout, double x_m, Random& random) {
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  const double kind = random.unit();
  Person person;
  if (kind < 0.4) {  // comes towards the robot
    const double y = side * random.between(0.0, 0.8);
    person.path = {{x_m + 6.0, y}, {x_m - 12.0, y}};
    person.speed_m_s = random.between(0.7, 1.3);
    person.starts_at_m = 9.0;
  } else if (kind < 0.7) {  // crosses
    person.path = {{x_m, side * 0.95}, {x_m, -side * 0.95}};
    person.speed_m_s = random.between(0.6, 1.2);
    person.starts_at_m = random.between(2.2, 4.0);
    person.present_after = false;  // leaves through a door
  } else {                         // steps before the robot, waits, and goes back
    person.path = {{x_m, side * 0.95}, {x_m, side * 0.1}, {x_m + 1.0, side * 0.95}};
    person.speed_m_s = random.between(0.7, 1.1);
    person.starts_at_m = random.between(2.0, 3.0);
    person.pause_s = random.between(2.0, 5.0);
    person.present_after = false;
  }
  layout.people.push_back(person);
}

/// One of endlessly many: the same seed gives the same corridor.
inline Layout random_corridor(std::uint64_t seed, double length_m = 30.0) {
  Random random(seed);
  Layout layout;
  layout.goal_x_m = length_m;
  layout.start = {0.0, random.between(-0.35, 0.35), random.between(-0.10, 0.10)};
  layout.corridor_views = random.chance(0.5);
  const double blank_share = random.chance(0.3) ? 0.5 : 0.1;
  const double end_m = length_m + 8.0;
  const bool widens = random.chance(0.3);
  const double wide_from = random.between(10.0, 16.0);
  const double wide_to = wide_from + 7.0;
  if (widens) {
    add_walls(layout, -1.5, wide_from, kHalfCorridor_m, random, blank_share);
    add_widening(layout, wide_from, wide_to, 2.5);
    add_walls(layout, wide_to, end_m, kHalfCorridor_m, random, blank_share);
  } else {
    add_walls(layout, -1.5, end_m, kHalfCorridor_m, random, blank_share);
  }
  layout.faces.push_back({{-1.5, -kHalfCorridor_m}, {-1.5, kHalfCorridor_m}, 0.0, 2.7, false});
  double side = random.chance(0.5) ? 1.0 : -1.0;
  for (double x = random.between(3.0, 5.0); x < length_m - 1.0; x += random.between(2.6, 5.0)) {
    if (widens && x > wide_from - 0.8 && x < wide_to + 0.8) continue;
    add_hurdle(layout, x, side, random);
    if (random.chance(0.7)) side = -side;
  }
  const int people = static_cast<int>(random.between(0.0, 3.5));
  for (int i = 0; i < people; ++i) add_person(layout, random.between(6.0, length_m - 4.0), random);
  return layout;
}

}  // namespace striate::flat
