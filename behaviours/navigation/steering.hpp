#pragma once

#include "striate/behaviours/control/footprint.hpp"
#include "striate/behaviours/navigation/path_planner.hpp"

namespace striate::behaviours {

/// Drive and turn for one cycle.
struct Drive {
  bool possible = false;
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
  double least_clearance_m = 0.0;  ///< of the outline on the rolled-out arc
};

/// Follows a way by pure pursuit (Coulter 1992), and rolls every candidate arc out with the real
/// outline before it is wished: pure pursuit cuts corners.
class Steering {
 public:
  Steering(const RobotDescription& robot, double wanted_clearance_m)
      : robot_(robot),
        footprint_(with_room_before(robot)),
        wanted_clearance_m_(wanted_clearance_m) {}

  /// `speed_m_s`: as fast as anything else allows. `least_clearance_m`: nearer than this only
  /// where the robot already is so near, and only on arcs that lead away.
  /// Unless `daring` no arc squeezes between a thing and the edge of what is seen, and none leads
  /// up to a remembered wall: a blank wall leaves no trace in the map, or a wrong one.
  struct Limits {
    double speed_m_s = 0.0;
    double least_clearance_m = 0.0;
    bool daring = false;
    double direction_rad = 0.0;                   ///< of the walls, odometry frame
    double left_wall_m = perception::kNothing_m;  ///< from the axle
    double right_wall_m = perception::kNothing_m;
  };
  [[nodiscard]] Drive follow(const Path& way, const FloorField& field, const Pose2& robot,
                             const Limits& limits) const;

  /// The point of the way at this length from its start (its end if it is shorter).
  [[nodiscard]] static Point2 point_at(const Path& way, double length_m);
  [[nodiscard]] const Footprint& footprint() const { return footprint_; }

 private:
  struct Candidate {
    double forward_m_s;
    double turn_rad_s;
  };
  [[nodiscard]] static RobotDescription with_room_before(RobotDescription robot);
  [[nodiscard]] double roll_out(const FloorField& field, const Pose2& robot,
                                const Candidate& candidate, double least_clearance_m) const;
  [[nodiscard]] bool keeps_off_walls(const Pose2& robot, const Candidate& candidate,
                                     const Limits& limits) const;
  [[nodiscard]] Drive turn_in_place(double angle_rad, const FloorField& field, const Pose2& robot,
                                    double least_clearance_m) const;

  RobotDescription robot_;
  Footprint footprint_;
  double wanted_clearance_m_;
};

}  // namespace striate::behaviours
