#include "striate/behaviours/navigation/journey.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "striate/behaviours/traverse_corridor.hpp"

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from"; the mission is find_and_return.yaml.

constexpr double kAlongCorridor_rad = 0.6;  // by hand: so far off its axis it still leads there
// By hand: a line nearer to a wall is the drift's, not the way's; leaves 0.34 m beside the flank,
// about what full pace needs (SpeedLimitSettings::roomy_m).
constexpr double kFromWall_m = 0.55;
constexpr double kDirect_m = 2.0;           // by hand: nearer goals are driven to without the trail
constexpr double kTrajectoryAhead_m = 2.0;  // by hand: so far on along the trail is steered for
constexpr double kTrajectoryServes_m =
    2.5;  // by hand: farther off, the trail does not lead to the goal
constexpr double kOnTrajectory_m = 1.0;  // by hand: four crumbs; so near is the same pass
// By hand: half the body's deceleration for the last way, and the speed that it ends with.
constexpr double kEasing_m_s2 = 0.25;
constexpr double kSlowestJourney_m_s = 0.12;

/// The crumb where the robot is. Where it has passed more than once, the one next to `to`.
std::size_t crumb_here(const memory::Trajectory& trajectory, Point2 here, std::size_t to) {
  std::size_t best = trajectory.nearest(here);
  const auto steps = [to](std::size_t i) { return i > to ? i - to : to - i; };
  for (std::size_t i = 0; i < trajectory.count(); ++i) {
    if (apart_m(trajectory.at(i), here) < kOnTrajectory_m && steps(i) < steps(best)) best = i;
  }
  return best;
}

}  // namespace

double distance_to_m(const memory::ShortTermMemory& memory, Point2 place) {
  return apart_m(place, {memory.pose().x_m, memory.pose().y_m});
}

Course course_toward(const memory::ShortTermMemory& memory, Point2 goal, double cruise_m_s) {
  const memory::CorridorMemory& corridor = memory.corridor();
  const Pose2& pose = memory.pose();
  const double bearing_rad = std::atan2(goal.y_m - pose.y_m, goal.x_m - pose.x_m);
  const bool back =
      std::abs(wrap_angle(bearing_rad - corridor.axis_rad())) > 0.5 * std::numbers::pi;
  Course course = corridor_course(corridor, back, cruise_m_s);
  if (std::abs(wrap_angle(bearing_rad - course.direction_rad)) < kAlongCorridor_rad) {
    const Pose2 line{pose.x_m, pose.y_m, course.direction_rad};
    const double room_m = std::max(0.0, course.half_corridor_m - kFromWall_m);
    course.wanted_left_m = std::clamp(inverse_transform(line, goal).y_m,
                                      course.middle_left_m - room_m, course.middle_left_m + room_m);
    return course;
  }
  course = {};
  course.direction_rad = bearing_rad;
  course.cruise_m_s = cruise_m_s;
  return course;
}

Point2 next_on_trajectory(const memory::ShortTermMemory& memory, Point2 goal) {
  const memory::Trajectory& trajectory = memory.trajectory();
  const Point2 here{memory.pose().x_m, memory.pose().y_m};
  if (trajectory.count() < 2 || apart_m(here, goal) < kDirect_m) return goal;
  const std::size_t last = trajectory.nearest(goal);
  if (apart_m(trajectory.at(last), goal) > kTrajectoryServes_m) return goal;
  std::size_t i = crumb_here(trajectory, here, last);
  double way_m = 0.0;
  while (i != last && way_m < kTrajectoryAhead_m) {
    const std::size_t next = i < last ? i + 1 : i - 1;
    way_m += apart_m(trajectory.at(i), trajectory.at(next));
    i = next;
  }
  return i == last ? goal : trajectory.at(i);
}

Wish Journey::tick(const memory::ShortTermMemory& memory, Point2 goal, double cruise_m_s) {
  const double eased_m_s = std::sqrt(2.0 * kEasing_m_s2 * distance_to_m(memory, goal));
  const double speed_m_s = std::min(cruise_m_s, std::max(kSlowestJourney_m_s, eased_m_s));
  return steer(memory, next_on_trajectory(memory, goal), speed_m_s);
}

Wish Journey::steer(const memory::ShortTermMemory& memory, Point2 toward, double cruise_m_s) {
  return follower_.tick(memory, course_toward(memory, toward, cruise_m_s));
}

}  // namespace striate::behaviours
