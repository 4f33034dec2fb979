#pragma once

#include <optional>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/straight_line.hpp"
#include "striate/behaviours/turn_to.hpp"
#include "striate/config/settings.hpp"

namespace striate::behaviours {

/// Shows a thing to memory: picks what stands out ahead, and looks at it from several places, from
/// where it is, from nearer, and from both sides. At each place it stands still until the image
/// is sharp and then says kTakesView for one cycle; who teaches keeps the view then. A place that
/// cannot be reached is left out.
class Teach : public Behaviour {
 public:
  struct Settings {
    int views = 4;         ///< with these eight of eight things were found: `trial --objects`
    double near_m = 1.05;  ///< by hand: about the nearest distance of `trial --objects`
    double aside_rad = radians(25.0);  ///< by hand: two views 50 degrees apart
    double tilt_rad = RobotDescription{}.resting_tilt_rad;
  };
  /// The reason of the wish in the cycle whose image is to be kept.
  static constexpr const char* kTakesView = "looks still: a view is kept";

  /// With the head's resting tilt of that robot.
  [[nodiscard]] static Settings defaults_for(const RobotDescription& robot) {
    return {.tilt_rad = robot.resting_tilt_rad};
  }
  Teach(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;

 private:
  enum class Phase { choose, turn_there, drive_there, face, settle, done };

  Wish choose(const memory::ShortTermMemory& memory);
  Wish settle(const memory::ShortTermMemory& memory);
  Wish end(const memory::ShortTermMemory& memory) const;
  /// Goes on with the next place, or to the end.
  void next_place(const memory::ShortTermMemory& memory);
  void turn_towards(const Point2& place, const memory::ShortTermMemory& memory, Phase phase);
  [[nodiscard]] Point2 place_of_view(int number) const;
  [[nodiscard]] Wish with_head(Wish wish, const memory::ShortTermMemory& memory) const;

  Settings settings_;
  RobotDescription robot_;
  Phase phase_ = Phase::choose;
  TimePoint since_{};
  int view_ = 0;           ///< the one that is sought
  int kept_ = 0;           ///< views so far
  Point2 thing_;           ///< odometry frame
  double line_rad_ = 0.0;  ///< from the thing to where the robot stood first, odometry frame
  Point2 goal_;
  std::optional<TurnTo> turn_;
  std::optional<StraightLine> line_;
};

template <class V>
void visit(V& v, Teach::Settings& s) {
  using config::Unit;
  v.integer("views", s.views, {1, 6}, "places from which it is looked at");
  v.number("near", s.near_m, Unit::length, {0.6, 3.0}, "how near it goes");
  v.number("aside", s.aside_rad, Unit::angle, {0.05, 0.8}, "how far to the sides it goes");
  v.number("tilt", s.tilt_rad, Unit::angle, {-0.6, 0.6}, "of the head, up positive");
}

}  // namespace striate::behaviours
