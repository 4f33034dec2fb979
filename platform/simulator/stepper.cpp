#include "striate/platform/simulator/stepper.hpp"

#include <algorithm>
#include <cmath>

#include "striate/platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {
namespace {

/// Before the robot's front; beyond its way to stop at 0.75 m/s, 0.8 m with reaction
constexpr double kNearest_m = 1.2;
/// Before the robot's front: farther is no stepping in front (ours)
constexpr double kFarthest_m = 2.5;
/// Beyond what the robot needs to stop: a person appears where it can (ours)
constexpr double kSpared_m = 0.6;
constexpr double kPace_m_s = 1.1;  ///< a relaxed walk (ours)
/// Waits this long for a door to come up: 9 m of the robot's way (ours)
constexpr double kDoorPatience_s = 12.0;
/// Appears this far ahead where no door is: beyond what stereo tells (one px is 6 m there)
constexpr double kAhead_m = 12.0;
/// And at least this far: six seconds and more before they meet
constexpr double kAheadLeast_m = 8.0;
/// So far away he may vanish without a door: beyond where obstacles are judged (8 m of floor)
constexpr double kGone_m = 9.0;

/// Held up for so long while coming, he stops where he is (ours).
constexpr double kStopsAfter_s = 1.5;
/// Held up for so long while leaving, he looks for another way (ours).
constexpr double kOtherWay_s = 5.0;
/// A robot slower than this stands: stepping in front of it shows nothing (ours).
constexpr double kRobotDrives_m_s = 0.1;
/// A door comes up within this of where they would meet: 0.7 s of the robot's way (ours)
constexpr double kDoorSlack_m = 0.5;
/// Nor farther to the side: half of the widest corridor, 5 m.
constexpr double kDoorAside_m = 2.5;
/// Ends of a corridor are walls: a person and a step (ours).
constexpr double kFromEnd_m = 0.5;
/// To the side of the middle, where he comes or goes: half of a corridor's half width (1.2 m)
constexpr double kAside_m = 0.6;
/// Nobody appears nearer to another: two radii and a step (ours).
constexpr double kRoomToAppear_m = 1.0;
/// So far a door is looked for, and so far he goes along the corridor: well beyond kGone_m (ours).
constexpr double kLeaves_m = 15.0;

}  // namespace

Stepper::Stepper(const StepInFront& step, std::uint64_t seed, std::uint64_t number)
    : step_(step), random_(seed, Purpose::step_in_front), drawn_(number << 32) {
  look_ = static_cast<int>(random_.bits(drawn_++) % 64);
  be_gone(0.0);
}

void Stepper::be_gone(double now_s) {
  walker_.vanish();
  doing_ = Doing::nothing;
  due_s_ = step_.per_minute > 0.0 ? now_s + draw(0.5, 1.5) * 60.0 / step_.per_minute
                                  : std::numeric_limits<double>::infinity();
  before_m_ = draw(kNearest_m, kFarthest_m);
  aside_m_ = draw(-0.2, 0.2);
}

void Stepper::decide(double now_s, const RobotNearby& place, const Surroundings& around) {
  switch (doing_) {
    case Doing::nothing:
      try_to_come(now_s, place, around);
      return;
    case Doing::coming: {
      const Point2 seen = inverse_transform(around.robot, walker_.at());
      const bool too_late = seen.x_m < place.robot.front_m;
      if (walker_.arrived() || walker_.held_up_s() > kStopsAfter_s || too_late) {
        walker_.stand();
        doing_ = Doing::waiting;
        since_s_ = now_s;
      }
      break;
    }
    case Doing::waiting:
      walker_.face({around.robot.x_m, around.robot.y_m});
      if (now_s - since_s_ >= step_.wait_s) {
        leave(place, around);
        doing_ = Doing::leaving;
        since_s_ = now_s;
      }
      break;
    case Doing::leaving: {
      const bool far = distance_m(walker_.at(), {around.robot.x_m, around.robot.y_m}) > kGone_m;
      if (through_door_ ? walker_.arrived() : far) {
        be_gone(now_s);
        return;
      }
      if (walker_.arrived() || walker_.held_up_s() > kOtherWay_s) leave(place, around);
      break;
    }
  }
  walker_.decide(around);
}

void Stepper::try_to_come(double now_s, const RobotNearby& place, const Surroundings& around) {
  if (now_s < due_s_ || around.robot_forward_m_s < kRobotDrives_m_s) return;
  const bool comes = come_through_a_door(place, around) ||
                     (now_s > due_s_ + kDoorPatience_s && come_from_ahead(place, around));
  if (!comes) return;
  doing_ = Doing::coming;
  since_s_ = now_s;
}

bool Stepper::come_through_a_door(const RobotNearby& place, const Surroundings& around) {
  const double v = around.robot_forward_m_s;
  const double before = std::max(before_m_, stopping_distance_m(v, place.robot) + kSpared_m);
  for (const Doorway& door : *place.doors) {
    // Robot and person meet: while he walks the robot comes nearer.
    const Point2 seen = inverse_transform(around.robot, door.inside);
    const double walk_s = (std::abs(seen.y_m) + distance_m(door.outside, door.inside)) / kPace_m_s;
    const double ahead = place.robot.front_m + v * walk_s + before + kPersonRadius_m;
    if (std::abs(seen.x_m - ahead) > kDoorSlack_m || std::abs(seen.y_m) > kDoorAside_m) continue;
    const Point2 target = transform(around.robot, Point2{ahead, aside_m_});
    if (place.map->at(target) < kPersonRoom_m) continue;
    auto way = place.map->way(door.inside, target, kPersonRoom_m);
    if (!way) continue;
    way->insert(way->begin(), door.outside);
    walker_.appear(
        {door.outside.x_m, door.outside.y_m,
         std::atan2(door.inside.y_m - door.outside.y_m, door.inside.x_m - door.outside.x_m)},
        look_);
    walker_.go(std::move(*way), kPace_m_s, {door.sill});
    return true;
  }
  return false;
}

bool Stepper::come_from_ahead(const RobotNearby& place, const Surroundings& around) {
  const Pose2 corridor = place.plan->along(around.robot);
  const double sign = std::cos(corridor.heading_rad) >= 0.0 ? 1.0 : -1.0;
  const double end = sign > 0.0 ? place.world->length_m - corridor.x_m : corridor.x_m;
  const double away = std::min(kAhead_m, end - kFromEnd_m);
  if (away < kAheadLeast_m) return false;
  const double v = around.robot_forward_m_s;
  const double before = std::max(before_m_, stopping_distance_m(v, place.robot) + kSpared_m);
  const double fixed = place.robot.front_m + before + kPersonRadius_m;
  const double meet_m = fixed + v * (away - fixed) / (v + kPace_m_s);
  const auto in_plan = [&](double ahead_m, double left_m) {
    const Pose2 pose = place.plan->at(corridor.x_m + sign * ahead_m, left_m);
    return Point2{pose.x_m, pose.y_m};
  };
  const Point2 from = in_plan(away, corridor.y_m > 0.0 ? -kAside_m : kAside_m);
  const Point2 target = in_plan(meet_m, corridor.y_m + aside_m_);
  if (place.map->at(from) < kPersonRoom_m || place.map->at(target) < kPersonRoom_m) return false;
  for (const Passer& other : around.others) {
    if (distance_m(other.at, from) < kRoomToAppear_m) return false;
  }
  auto way = place.map->way(from, target, kPersonRoom_m);
  if (!way) return false;
  walker_.appear({from.x_m, from.y_m, std::atan2(target.y_m - from.y_m, target.x_m - from.x_m)},
                 look_);
  walker_.go(std::move(*way), kPace_m_s);
  return true;
}

void Stepper::leave(const RobotNearby& place, const Surroundings& around) {
  if (auto out = way_out(walker_.at(), *place.doors, *place.map, kLeaves_m)) {
    through_door_ = true;
    walker_.go(std::move(out->way), kPace_m_s, {out->door});
    return;
  }
  // No door near: away from the robot, along the corridor, until nobody would see him vanish.
  through_door_ = false;
  const Pose2 corridor = place.plan->along({walker_.at().x_m, walker_.at().y_m, 0.0});
  const Pose2 robot = place.plan->along(around.robot);
  const double goal = corridor.x_m >= robot.x_m
                          ? std::min(corridor.x_m + kLeaves_m, place.world->length_m - kFromEnd_m)
                          : std::max(corridor.x_m - kLeaves_m, kFromEnd_m);
  for (const double left : {kAside_m, -kAside_m, 0.0}) {
    const Pose2 pose = place.plan->at(goal, left);
    if (auto way = place.map->way(walker_.at(), {pose.x_m, pose.y_m}, kPersonRoom_m)) {
      walker_.go(std::move(*way), kPace_m_s);
      return;
    }
  }
}

}  // namespace striate::simulator
