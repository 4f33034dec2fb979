#include <algorithm>
#include <cmath>
#include <limits>

#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/walker.hpp"

namespace striate::simulator {
namespace {

constexpr double kLookAhead_m = 1.0;  ///< on the way, for where to go: a second's walk (ours)
/// On his way, from where he makes for its side: kMoments at a walk, and the robot's own (ours)
constexpr double kSeesRobot_m = 2.5;
/// From its middle when passing: half width, radius and most of kComfort_m
constexpr double kBeside_m = 0.72;
constexpr double kDoorReach_m =
    0.8;  ///< nearer to a door a walker is in it: a stride's half (ours)

}  // namespace

Point2 Walker::point_on_path(double along_m) const {
  for (std::size_t i = 0; i + 1 < way_.size(); ++i) {
    const double length = distance_m(way_[i], way_[i + 1]);
    if (along_m <= length && length > 0.0) {
      const double t = along_m / length;
      return {way_[i].x_m + t * (way_[i + 1].x_m - way_[i].x_m),
              way_[i].y_m + t * (way_[i + 1].y_m - way_[i].y_m)};
    }
    along_m -= length;
  }
  return way_.back();
}

std::vector<Point2> Walker::rest_of_path() const {
  std::vector<Point2> rest;
  double along = 0.0;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    if (i > 0) along += distance_m(way_[i - 1], way_[i]);
    if (along > progress_m_) rest.push_back(way_[i]);
  }
  if (!rest.empty()) rest.insert(rest.begin(), at());
  return rest;
}

void Walker::find_progress() {
  // He never goes back: the nearest place on the next metre counts.
  double best = progress_m_;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 20; ++i) {
    const double along = std::min(progress_m_ + 0.05 * i, length_m_);
    const double away = distance_m(at(), point_on_path(along));
    if (away < nearest) {
      nearest = away;
      best = along;
    }
  }
  progress_m_ = best;
}

Point2 Walker::target_on_path(const Surroundings& around) const {
  const Point2 here = point_on_path(progress_m_);
  const Point2 target = point_on_path(std::min(progress_m_ + kLookAhead_m, length_m_));
  if (distance_m(here, target) < 0.05) return target;
  // Where the robot is in the way he makes early for a place beside it, on the side with room.
  const Pose2 way{state_.pose.x_m, state_.pose.y_m,
                  std::atan2(target.y_m - here.y_m, target.x_m - here.x_m)};
  const Point2 robot = inverse_transform(way, Point2{around.robot.x_m, around.robot.y_m});
  const bool in_the_way =
      distance_to_segment_m({around.robot.x_m, around.robot.y_m}, here,
                            point_on_path(std::min(progress_m_ + kSeesRobot_m, length_m_))) <
      kBeside_m;
  if (!in_the_way || robot.x_m < -0.4) return target;
  const double ahead = robot.x_m > 1.2 ? robot.x_m - 0.7 : std::max(0.5, robot.x_m + 0.2);
  const double near_side = robot.y_m > 0.0 ? -1.0 : 1.0;
  for (const double side : {near_side, -near_side}) {
    const Point2 beside = transform(way, Point2{robot.x_m, robot.y_m + side * kBeside_m});
    if (around.map->at(beside) < kPersonRadius_m + 0.02) continue;
    return transform(way, Point2{ahead, robot.y_m + side * kBeside_m});
  }
  return target;
}

bool Walker::at_a_door(Point2 place) const {
  return std::any_of(doors_.begin(), doors_.end(),
                     [&](const Point2& door) { return distance_m(place, door) < kDoorReach_m; });
}

}  // namespace striate::simulator
