#pragma once

#include <array>

#include "striate/behaviours/control/floor_field.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// The robot's outline on the floor: a rectangle about the axle.
class Footprint {
 public:
  explicit Footprint(const RobotDescription& robot);

  /// Least clearance of the outline at `pose` (odometry frame): 0 touches.
  [[nodiscard]] double clearance_m(const FloorField& field, const Pose2& pose) const;

  /// The same from the edge of what is seen free.
  [[nodiscard]] double seen_clearance_m(const FloorField& field, const Pose2& pose) const;

  /// Signed distance of a point in the robot frame from the outline; inside is negative.
  [[nodiscard]] double distance_m(Point2 robot_frame) const;

  /// How far the outline at `pose` reaches to the left, and to the right, of the x axis of the
  /// frame that `pose` is in.
  [[nodiscard]] double farthest_left_m(const Pose2& pose) const;
  [[nodiscard]] double farthest_right_m(const Pose2& pose) const;

  [[nodiscard]] double front_m() const { return front_m_; }
  [[nodiscard]] double rear_m() const { return rear_m_; }
  [[nodiscard]] double half_width_m() const { return half_width_m_; }

 private:
  double front_m_;
  double rear_m_;
  double half_width_m_;
  std::array<Point2, 12> outline_;
};

/// Where the robot is after `time_s` on the arc of (forward, turn).
[[nodiscard]] Pose2 along_arc(const Pose2& from, double forward_m_s, double turn_rad_s,
                              double time_s);

}  // namespace striate::behaviours
