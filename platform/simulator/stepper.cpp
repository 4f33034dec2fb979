#include "platform/simulator/stepper.hpp"

#include <algorithm>
#include <cmath>

#include "platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {
namespace {

/// Before the robot's front; beyond its way to stop at 0.75 m/s, 0.8 m with reaction
constexpr double kNearestM = 1.2;
/// Before the robot's front: farther is no stepping in front (ours)
constexpr double kFarthestM = 2.5;
/// Beyond what the robot needs to stop: a person appears where it can (ours)
constexpr double kSparedM = 0.6;
constexpr double kPaceM_s = 1.1;  ///< a relaxed walk (ours)
/// A person, and 2 cm that a walker's steps err by
constexpr double kRoomM = kPersonRadius_m + 0.02;
/// Waits this long for a door to come up: 9 m of the robot's way (ours)
constexpr double kDoorPatienceS = 12.0;
/// Appears this far ahead where no door is: beyond what stereo tells (one px is 6 m there)
constexpr double kAheadM = 12.0;
/// And at least this far: six seconds and more before they meet
constexpr double kAheadLeastM = 8.0;
/// So far away he may vanish without a door: beyond where obstacles are judged (8 m of floor)
constexpr double kGoneM = 9.0;

/// Held up for so long while coming, he stops where he is (ours).
constexpr double kStopsAfterS = 1.5;
/// Held up for so long while leaving, he looks for another way (ours).
constexpr double kOtherWayS = 5.0;
/// A robot slower than this stands: stepping in front of it shows nothing (ours).
constexpr double kRobotDrivesM_s = 0.1;
/// A door comes up within this of where they would meet: 0.7 s of the robot's way (ours)
constexpr double kDoorSlackM = 0.5;
/// Nor farther to the side: half of the widest corridor, 5 m.
constexpr double kDoorAsideM = 2.5;
/// Ends of a corridor are walls: a person and a step (ours).
constexpr double kFromEndM = 0.5;
/// To the side of the middle, where he comes or goes: half of a corridor's half width (1.2 m)
constexpr double kAsideM = 0.6;
/// Nobody appears nearer to another: two radii and a step (ours).
constexpr double kFreeToAppearM = 1.0;
/// So far a door is looked for, and so far he goes along the corridor: well beyond kGoneM (ours).
constexpr double kLeavesM = 15.0;

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
  before_m_ = draw(kNearestM, kFarthestM);
  aside_m_ = draw(-0.2, 0.2);
}

void Stepper::decide(double now_s, const Place& place, const Surroundings& around) {
  switch (doing_) {
    case Doing::nothing:
      try_to_come(now_s, place, around);
      return;
    case Doing::coming: {
      const Point2 seen = to_inner(around.robot, walker_.at());
      const bool too_late = seen.x_m < place.robot.front_m;
      if (walker_.arrived() || walker_.held_up_s() > kStopsAfterS || too_late) {
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
      const bool far = distance_m(walker_.at(), {around.robot.x_m, around.robot.y_m}) > kGoneM;
      if (through_door_ ? walker_.arrived() : far) {
        be_gone(now_s);
        return;
      }
      if (walker_.arrived() || walker_.held_up_s() > kOtherWayS) leave(place, around);
      break;
    }
  }
  walker_.decide(around);
}

void Stepper::try_to_come(double now_s, const Place& place, const Surroundings& around) {
  if (now_s < due_s_ || around.robot_forward_m_s < kRobotDrivesM_s) return;
  const bool comes = come_through_a_door(place, around) ||
                     (now_s > due_s_ + kDoorPatienceS && come_from_ahead(place, around));
  if (!comes) return;
  doing_ = Doing::coming;
  since_s_ = now_s;
}

bool Stepper::come_through_a_door(const Place& place, const Surroundings& around) {
  const double v = around.robot_forward_m_s;
  const double before = std::max(before_m_, stopping_way_m(v, place.robot) + kSparedM);
  for (const Doorway& door : *place.doors) {
    // Robot and person meet: while he walks the robot comes nearer.
    const Point2 seen = to_inner(around.robot, door.inside);
    const double walk_s = (std::abs(seen.y_m) + distance_m(door.outside, door.inside)) / kPaceM_s;
    const double ahead = place.robot.front_m + v * walk_s + before + kPersonRadius_m;
    if (std::abs(seen.x_m - ahead) > kDoorSlackM || std::abs(seen.y_m) > kDoorAsideM) continue;
    const Point2 target = to_outer(around.robot, Point2{ahead, aside_m_});
    if (place.map->at(target) < kRoomM) continue;
    auto way = place.map->way(door.inside, target, kRoomM);
    if (!way) continue;
    way->insert(way->begin(), door.outside);
    walker_.appear(
        {door.outside.x_m, door.outside.y_m,
         std::atan2(door.inside.y_m - door.outside.y_m, door.inside.x_m - door.outside.x_m)},
        look_);
    walker_.go(std::move(*way), kPaceM_s, {door.sill});
    return true;
  }
  return false;
}

bool Stepper::come_from_ahead(const Place& place, const Surroundings& around) {
  const Pose2 corridor = place.plan->along(around.robot);
  const double sign = std::cos(corridor.heading_rad) >= 0.0 ? 1.0 : -1.0;
  const double end = sign > 0.0 ? place.world->length_m - corridor.x_m : corridor.x_m;
  const double away = std::min(kAheadM, end - kFromEndM);
  if (away < kAheadLeastM) return false;
  const double v = around.robot_forward_m_s;
  const double before = std::max(before_m_, stopping_way_m(v, place.robot) + kSparedM);
  const double fixed = place.robot.front_m + before + kPersonRadius_m;
  const double meet_m = fixed + v * (away - fixed) / (v + kPaceM_s);
  const auto in_plan = [&](double ahead_m, double left_m) {
    const Pose2 pose = place.plan->at(corridor.x_m + sign * ahead_m, left_m);
    return Point2{pose.x_m, pose.y_m};
  };
  const Point2 from = in_plan(away, corridor.y_m > 0.0 ? -kAsideM : kAsideM);
  const Point2 target = in_plan(meet_m, corridor.y_m + aside_m_);
  if (place.map->at(from) < kRoomM || place.map->at(target) < kRoomM) return false;
  for (const Passer& other : around.others) {
    if (distance_m(other.at, from) < kFreeToAppearM) return false;
  }
  auto way = place.map->way(from, target, kRoomM);
  if (!way) return false;
  walker_.appear({from.x_m, from.y_m, std::atan2(target.y_m - from.y_m, target.x_m - from.x_m)},
                 look_);
  walker_.go(std::move(*way), kPaceM_s);
  return true;
}

void Stepper::leave(const Place& place, const Surroundings& around) {
  if (auto out = way_out(walker_.at(), *place.doors, *place.map, kLeavesM)) {
    through_door_ = true;
    walker_.go(std::move(out->way), kPaceM_s, {out->door});
    return;
  }
  // No door near: away from the robot, along the corridor, until nobody would see him vanish.
  through_door_ = false;
  const Pose2 corridor = place.plan->along({walker_.at().x_m, walker_.at().y_m, 0.0});
  const Pose2 robot = place.plan->along(around.robot);
  const double goal = corridor.x_m >= robot.x_m
                          ? std::min(corridor.x_m + kLeavesM, place.world->length_m - kFromEndM)
                          : std::max(corridor.x_m - kLeavesM, kFromEndM);
  for (const double left : {kAsideM, -kAsideM, 0.0}) {
    const Pose2 pose = place.plan->at(goal, left);
    if (auto way = place.map->way(walker_.at(), {pose.x_m, pose.y_m}, kRoomM)) {
      walker_.go(std::move(*way), kPaceM_s);
      return;
    }
  }
}

}  // namespace striate::simulator
