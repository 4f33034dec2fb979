#pragma once

#include <string>
#include <vector>

#include "striate/platform/simulator/random_world/building_style.hpp"
#include "striate/platform/simulator/random_world/drawn_stretch.hpp"
#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// An obstacle's size before it is turned, in whole centimetres.
struct SizeCm {
  int x = 0;
  int y = 0;
  int z = 0;
};

/// A stretch along the corridor, in whole centimetres.
struct SpanCm {
  int from = 0;
  int to = 0;
};

/// Centimetres as the metres that a reader makes of them, to the last bit.
[[nodiscard]] inline double metres_of(int length_cm) {
  return length_cm / 100.0;
}

/// A building while it is drawn, from the start wall on. Everything is whole centimetres, degrees
/// and percent here.
struct Draft {
  Draft(const BuildingStyle& style_in, const Dice& dice_in) : style(style_in), dice(dice_in) {}

  const BuildingStyle& style;
  Dice dice;
  World world;
  std::vector<DrawnStretch> stretches;
  std::vector<SpanCm> dark;      ///< where lamps are nearly out
  std::vector<SpanCm> unbroken;  ///< where walls take no door, window or poster: steps and bends
  std::vector<SpanCm> sunny;     ///< where the windows of the sunlight are
  std::vector<int> somebody_comes_cm;  ///< where a person is to come towards the robot
  int width_cm = 0;
  int x_cm = 0;         ///< how far it is drawn
  int heading_deg = 0;  ///< of the corridor there

  /// Puts a thing down; `name` gets a number.
  WorldObstacle& put(ObstacleKind kind, const std::string& name, Point2 at, SizeCm size,
                     const std::string& image = {});
  /// Where the middle of a thing stands that covers `across_cm` of `wide_cm` and leaves a lane of
  /// `kLane_cm` on one side. As likely at a wall as well in the way.
  [[nodiscard]] double beside_a_lane_m(int across_cm, int wide_cm);
  /// The same for a thing that leans on the wall.
  [[nodiscard]] double at_a_wall_m(int across_cm, int wide_cm);
  /// What things may cover of the corridor's width.
  [[nodiscard]] int reach_cm() const;
  /// The corridor is `other_cm` wide over the span; its walls' steps take no doors.
  void other_width(SpanCm span, int other_cm);
  /// A piece of furniture that leaves a lane, `x_cm` along the corridor. Returns what it is.
  std::string put_furniture(int at_cm);

  /// Notes what was drawn from `from_cm` on, and goes on to `to_cm`.
  void finish_stretch(int from_cm, int to_cm, std::size_t first_obstacle, const std::string& story);
};

/// What every thing leaves free beside it: the way that must exist, and a hand's breadth.
inline constexpr int kLane_cm = 90;

// One stretch of corridor each, with what makes it hard.
void lay_low_thing(Draft& draft);
void lay_overhang(Draft& draft);
void lay_thin_poles(Draft& draft);
void lay_late_thing(Draft& draft);
void lay_furniture(Draft& draft);
void lay_pinch(Draft& draft);
void lay_dark(Draft& draft);
void lay_bend(Draft& draft);
void lay_pocket(Draft& draft);
void lay_sunlight(Draft& draft);
void lay_ring(Draft& draft);
void lay_side_branch(Draft& draft);
void lay_glass(Draft& draft);
void lay_stairs(Draft& draft);
void lay_wet_floor(Draft& draft);

// What is everywhere, when all stretches are laid and the corridor's length is known.
void hang_lamps(Draft& draft);
void furnish_walls(Draft& draft);
/// @returns what a crowd is made of, for the note
std::string send_people(Draft& draft, bool crowd);

}  // namespace striate::simulator
