#pragma once

#include "striate/behaviours/navigation/path_follower.hpp"

namespace striate::behaviours {

/// The course from the robot to `goal` (odometry frame). Where the goal lies along the remembered
/// corridor it is the corridor's course on a line through the goal, with the corridor's walls; else
/// it leads straight to the goal and knows of walls only what the map holds.
[[nodiscard]] Course course_toward(const memory::ShortTermMemory& memory, Point2 goal,
                                   double cruise_m_s);

/// What to steer for on the way to `goal`: where the trail of this run leads there, a point some
/// metres on along it, so that the way goes round the corners that the robot came round; else the
/// goal itself.
[[nodiscard]] Point2 next_on_trajectory(const memory::ShortTermMemory& memory, Point2 goal);

/// Drives to a place that the robot knows, round what stands in the way: along its own trail,
/// planning on the map like all that travel. Slows down before the goal. Shared by go_to,
/// return_to_start and approach_landmark.
class Journey {
 public:
  Journey(const DrivingSettings& settings, const RobotDescription& robot)
      : follower_(settings, robot) {}
  void start(const memory::ShortTermMemory& memory) { follower_.start(memory); }
  /// Running, or failed with a reason; whether it has arrived is for the caller to say.
  Wish tick(const memory::ShortTermMemory& memory, Point2 goal, double cruise_m_s);
  /// The same straight toward a point, without the trail and without slowing down.
  Wish steer(const memory::ShortTermMemory& memory, Point2 toward, double cruise_m_s);

 private:
  PathFollower follower_;
};

/// From the robot's axle to a place, along the floor.
[[nodiscard]] double distance_to_m(const memory::ShortTermMemory& memory, Point2 place);

}  // namespace striate::behaviours
