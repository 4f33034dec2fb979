#pragma once

#include <vector>

#include "striate/platform/simulator/clearance_map.hpp"
#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/shapes.hpp"

namespace striate::simulator {

/// Somebody else on the floor, as a walker sees him.
struct Passer {
  Point2 at;
  double velocity_x_m_s = 0.0;
  double velocity_y_m_s = 0.0;
};

/// What a walker looks at. The robot's shapes are in the plan.
struct Surroundings {
  const ClearanceMap* map = nullptr;
  Pose2 robot;
  double robot_forward_m_s = 0.0;
  double robot_turn_rad_s = 0.0;
  ConvexShape footprint;  ///< in the robot's frame
  ConvexShape body;       ///< the footprint where it is now
  ConvexShape braking;    ///< and all that it sweeps before it could stand
  std::vector<Passer> others;
};

/// How far the robot goes from deciding to stop until it stands: image, cycle, motors, brakes.
[[nodiscard]] double stopping_distance_m(double forward_m_s, const RobotDescription& robot);

/// A person who follows a way and looks where he goes. He sidesteps the robot where there is room,
/// stops short of it where there is none, and never by his own step comes nearer than a hand's
/// breadth to it or to where it could not stop any more.
class Walker {
 public:
  void appear(Pose2 at, int look);
  void vanish() { present_ = false; }
  /// Follows these points from now on. Near `doors` walls do not hold him.
  void go(std::vector<Point2> way, double speed_m_s, std::vector<Point2> doors = {});
  void stand() { way_.clear(); }
  /// What is left of his way, from where he is; empty where he has none.
  [[nodiscard]] std::vector<Point2> rest_of_path() const;

  /// Chooses where to step next; several times a second.
  void decide(const Surroundings& around);
  /// One physics step on.
  void step(double dt_s, const Surroundings& around);
  /// Turns to look at a place while standing.
  void face(Point2 place);

  [[nodiscard]] bool present() const { return present_; }
  [[nodiscard]] bool arrived() const;
  [[nodiscard]] const PersonState& state() const { return state_; }
  [[nodiscard]] Point2 at() const { return {state_.pose.x_m, state_.pose.y_m}; }
  [[nodiscard]] Passer passer() const { return {at(), velocity_x_m_s_, velocity_y_m_s_}; }
  /// For how long he has wanted to go on and could not.
  [[nodiscard]] double held_up_s() const { return held_up_s_; }

 private:
  struct Choice {
    double direction_rad = 0.0;
    double speed_m_s = 0.0;
  };
  [[nodiscard]] Point2 point_on_path(double along_m) const;
  [[nodiscard]] Point2 target_on_path(const Surroundings& around) const;
  void find_progress();
  [[nodiscard]] bool at_a_door(Point2 place) const;
  [[nodiscard]] double cost(const Choice& choice, Point2 target, const Surroundings& around) const;
  [[nodiscard]] double cost_at(Point2 place, double after_s, const Surroundings& around) const;
  [[nodiscard]] bool may_step_to(Point2 place, const Surroundings& around) const;
  void turn_towards(double heading_rad, double dt_s);
  void swing_legs(double dt_s);

  bool present_ = false;
  PersonState state_;
  double velocity_x_m_s_ = 0.0;
  double velocity_y_m_s_ = 0.0;
  double wanted_x_m_s_ = 0.0;
  double wanted_y_m_s_ = 0.0;
  double speed_m_s_ = 1.0;
  std::vector<Point2> way_;
  std::vector<Point2> doors_;
  double length_m_ = 0.0;
  double progress_m_ = 0.0;
  double facing_rad_ = 0.0;
  double held_up_s_ = 0.0;
};

}  // namespace striate::simulator
