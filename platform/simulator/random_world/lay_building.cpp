#include <fmt/format.h>

#include <algorithm>

#include "striate/platform/simulator/random_world/draft.hpp"

/// Stretches of other shape: rings, branches, glass doors, stairs, and floors that are none.
namespace striate::simulator {
namespace {

/// Before and behind such a stretch, as beside any other.
constexpr int kBeside_cm = 220;

}  // namespace

void lay_ring(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  Dice& dice = draft.dice;
  const int lane = dice.throw_in_steps({130, 180}, 2);  // a corridor of its own on either side
  const SizeCm block{dice.throw_in_steps({240, 500}, 10), dice.throw_in_steps({120, 300}, 2), 0};
  const int wide = 2 * lane + block.y;
  const int start = from + kBeside_cm;
  const int end = start + 2 * lane + block.x;
  draft.other_width({start, end}, wide);
  draft.put(ObstacleKind::wall, "wall", {metres_of(start + lane) + block.x / 200.0, 0.0},
            {block.x, block.y, 270}, dice.one_of(draft.style.walls));
  draft.finish_stretch(from, end + kBeside_cm, first,
                       fmt::format("a ring: two ways of {:.1f} m round a block", lane / 100.0));
}

void lay_side_branch(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  Dice& dice = draft.dice;
  const int mouth = dice.throw_in_steps({150, 220}, 2);
  const int deep = dice.throw_in_steps({200, 450}, 2);
  const int start = from + kBeside_cm;
  draft.other_width({start, start + mouth}, draft.width_cm + 2 * deep);
  const int closed = dice.throw_between({-1, 1});  // which arm is walled up; 0: neither
  if (closed != 0) {
    draft.put(ObstacleKind::wall, "wall",
              {metres_of(start) + mouth / 200.0, closed * (draft.width_cm + deep) / 200.0},
              {mouth, deep, 270}, dice.one_of(draft.style.walls));
  }
  draft.finish_stretch(
      from, start + mouth + kBeside_cm, first,
      closed == 0
          ? fmt::format("a crossing: arms of {:.1f} m to both sides, both blind", deep / 100.0)
          : fmt::format("a T: an arm of {:.1f} m to the {}, blind", deep / 100.0,
                        closed > 0 ? "right" : "left"));
}

void lay_glass(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  Dice& dice = draft.dice;
  const int at = from + kBeside_cm;
  // What is not open is glass: a shut leaf, and where the corridor is wide a fixed pane as well.
  const int open = dice.throw_in_steps({90, 110}, 2);
  const int glass = std::max(20, draft.width_cm - open);
  const int one = glass < 80 ? glass : dice.throw_in_steps({20, glass - 20}, 2);
  const int side = dice.sign();
  int panes = 0;
  const auto pane = [&](int wide, int of_side) {
    if (wide < 10) return;
    draft
        .put(ObstacleKind::glass, "glass",
             {metres_of(at), of_side * (draft.width_cm - wide) / 200.0}, {wide, 5, 205})
        .turn_rad = radians(90);
    ++panes;
  };
  pane(one, side);
  pane(glass - one, -side);
  draft.unbroken.push_back({at - 60, at + 60});
  draft.finish_stretch(from, at + kBeside_cm, first,
                       fmt::format("a glass door, {:.1f} m of it open, {} shut", open / 100.0,
                                   panes == 1 ? "one pane" : "two panes"));
}

void lay_stairs(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  Dice& dice = draft.dice;
  const SizeCm hole{dice.throw_in_steps({140, 260}, 2), dice.throw_in_steps({80, 120}, 2),
                    dice.throw_between({120, 200})};
  const int start = from + kBeside_cm;
  const int wide = std::max(draft.width_cm, hole.y + kLane_cm + 20);
  const int at = start + 60 + hole.x / 2;
  if (wide > draft.width_cm) {
    draft.other_width({start, start + hole.x + 120}, wide + wide % 2);
  }
  draft.put(ObstacleKind::stairs, "stairs", {metres_of(at), draft.at_a_wall_m(hole.y, wide)}, hole)
      .turn_rad = dice.chance(50) ? 0.0 : radians(180);
  draft.finish_stretch(from, start + hole.x + 120 + kBeside_cm, first,
                       fmt::format("stairs down beside the way, {:.1f} m wide", hole.y / 100.0));
}

void lay_wet_floor(Draft& draft) {
  const std::size_t first = draft.world.obstacles.size();
  const int from = draft.x_cm;
  Dice& dice = draft.dice;
  const int to = from + dice.throw_between({500, 700});
  const bool wet = dice.chance(60);
  const int wide = draft.width_cm * dice.throw_between({40, 95}) / 100;
  FloorPatch patch;
  patch.at = {metres_of((from + to) / 2), 0.0};
  patch.size_x_m = metres_of(dice.throw_between({120, 400}));
  patch.size_y_m = metres_of(wide);
  patch.material = wet ? "wet" : dice.one_of(std::vector{"carpet", "tiles", "paint_black"});
  draft.world.floor_patches.push_back(patch);
  draft.put_furniture((from + to) / 2 + dice.throw_between({-100, 100}));
  draft.finish_stretch(from, to, first,
                       wet ? "wet floor, which mirrors" : "a " + patch.material + " on the floor");
}

}  // namespace striate::simulator
